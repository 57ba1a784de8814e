// Draws every plot of the page from the JSON beside it, and makes the legends work. Needs the global `Plotly`.
(() => {
  "use strict";
  const plots = Array.from(document.querySelectorAll(".plot"));
  // On a touch screen a finger that moves over a plot wants to scroll the page, not to draw a zoom box.
  const touch = window.matchMedia("(pointer: coarse)").matches;
  const paper_width_px = 660; // A4 between its margins

  // The page keeps title and legend outside the plot, so a saved picture gets them back, at a width that holds them.
  function save_picture(plot, title, name) {
    const scale = Math.max(1, 760 / plot.clientWidth);
    const drawn = plot.data.concat(plot.layout.shapes);
    const layout = Object.assign({}, plot.layout, {
      title: { text: title, x: 0.02, xanchor: "left", y: 0.98, yanchor: "top", font: { size: 17 } },
      showlegend: drawn.filter((part) => part.showlegend).length > 1,
      legend: { orientation: "h", x: 0, y: 0, yref: "container", yanchor: "bottom" },
      margin: Object.assign({}, plot.layout.margin, { t: 52 }),
      autosize: false, width: scale * plot.clientWidth, height: scale * plot.clientHeight + 90,
    });
    Plotly.downloadImage({ data: plot.data, layout: layout },
      { format: "png", scale: 2, width: layout.width, height: layout.height, filename: name });
  }

  function draw(plot) {
    const figure = JSON.parse(document.getElementById(plot.id + "-data").textContent);
    if (touch) figure.layout.dragmode = false;
    const heading = plot.closest(".cell, figure").querySelector("h3");
    const title = heading.innerHTML; // already made safe; the plot library reads the same character references
    Plotly.newPlot(plot, figure.data, figure.layout, {
      responsive: true, displaylogo: false, displayModeBar: "hover",
      // The library would offer to send the data to its maker's server; nothing leaves this page.
      showSendToCloud: false, plotlyServerURL: "",
      modeBarButtonsToRemove: ["toImage", "select2d", "lasso2d", "autoScale2d"],
      modeBarButtonsToAdd: [{
        name: "save", title: "Save as PNG", icon: Plotly.Icons.camera,
        click: () => save_picture(plot, title, figure.name),
      }],
    });
  }

  function toggle(button) {
    const shown = button.getAttribute("aria-pressed") !== "true";
    button.setAttribute("aria-pressed", String(shown));
    const scope = button.closest(".cell, figure");
    for (const plot of scope.querySelectorAll(".plot")) {
      if (button.dataset.series) Plotly.restyle(plot, { visible: shown }, [Number(button.dataset.series)]);
      else Plotly.relayout(plot, { [`shapes[${button.dataset.band}].visible`]: shown });
    }
  }

  plots.forEach(draw);
  for (const button of document.querySelectorAll(".legend button")) {
    button.addEventListener("click", () => toggle(button));
  }

  // A plot keeps the width it has on the screen, which may be wider than paper.
  window.addEventListener("beforeprint", () => {
    for (const plot of plots) {
      const in_row = plot.closest(".row") !== null;
      Plotly.relayout(plot, { width: in_row ? paper_width_px / 2 - 12 : paper_width_px });
    }
  });
  window.addEventListener("afterprint", () => {
    for (const plot of plots) Plotly.relayout(plot, { width: null, autosize: true });
  });
})();
