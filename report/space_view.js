// Draws the lines in space of the page (report/space_view.hpp) on their canvases, and makes their controls work.
(() => {
  "use strict";
  // A part of the map "viridis": its light end would vanish on white.
  const colours = [[68, 1, 84], [59, 82, 139], [33, 145, 140], [94, 201, 98], [229, 190, 32]];
  const ink = "#1d2733", muted = "#5b6774", faint = "#c3cbd3", font = "13px system-ui, sans-serif";
  const aside = 0.45, begin_lift = 0.3; // [rad] from the side on which the line is widest; from above

  function colour_at(share) {
    const at = Math.min(Math.max(share, 0), 1) * (colours.length - 1), k = Math.min(Math.floor(at), colours.length - 2);
    const mix = colours[k].map((c, i) => Math.round(c + (at - k) * (colours[k + 1][i] - c)));
    return `rgb(${mix.join(",")})`;
  }

  function round_step(span, most) { // 1, 2 or 5 times a power of ten
    const rough = span / most, ten = 10 ** Math.floor(Math.log10(rough));
    return ten * (rough / ten > 5 ? 10 : rough / ten > 2 ? 5 : rough / ten > 1 ? 2 : 1);
  }

  const shown = (value) => Number(value.toPrecision(3)).toLocaleString("en");

  function start(view) {
    const data = JSON.parse(document.getElementById(view.id + "-data").textContent);
    const canvas = view.querySelector("canvas"), pen = canvas.getContext("2d");
    const part = (role) => view.querySelector(`[data-role="${role}"]`);
    const said = (role, text) => { part(role).parentElement.querySelector("output").textContent = text; };
    const turn = {};
    const ranges = data.names.map((_, k) => {
      let low = Infinity, high = -Infinity;
      for (const frame of data.frames) for (const v of frame.values[k]) { low = Math.min(low, v); high = Math.max(high, v); }
      return [low, high > low ? high : low + 1];
    });
    const bounds = data.guide.map((axis) => [Math.min(...axis), Math.max(...axis)]);
    const whole = bounds.map(([low, high]) => 0.5 * (low + high));
    const size = Math.max(...bounds.map(([low, high]) => high - low));
    const air = 0.06 * size;
    const box = bounds.map(([low, high]) => (high - low < 2 * air ? [0.5 * (low + high) - air, 0.5 * (low + high) + air] : [low, high]));
    const marks = data.marks, last = marks.length - 1;

    function on_guide(mark) { // the point of the guide at a mark
      let k = 0;
      while (k < last - 1 && marks[k + 1] < mark) ++k;
      const share = Math.min(Math.max((mark - marks[k]) / (marks[k + 1] - marks[k] || 1), 0), 1);
      return data.guide.map((axis) => axis[k] + share * (axis[k + 1] - axis[k]));
    }

    function reset() {
      const far = data.guide.map((axis) => axis[last] - axis[0]);
      turn.azimuth = (Math.hypot(far[0], far[1]) > 0 ? Math.PI / 2 - Math.atan2(far[1], far[0]) : 0) - aside;
      turn.lift = begin_lift;
      part("time").value = 1;
      part("magnification").value = Math.log(data.magnification) / Math.log(data.most);
      part("zoom").value = 0;
      part("middle").value = 1;
    }

    function draw() {
      const dots = window.devicePixelRatio || 1, width = canvas.clientWidth, height = canvas.clientHeight;
      canvas.width = Math.round(width * dots);
      canvas.height = Math.round(height * dots);
      pen.setTransform(dots, 0, 0, dots, 0, 0);
      pen.font = font;
      pen.lineJoin = pen.lineCap = "round";
      const frame = data.frames[Math.round(Number(part("time").value) * (data.frames.length - 1))];
      const which = Number(part("value").value), [low, high] = ranges[which];
      const magnified = data.most ** Number(part("magnification").value);
      const zoom = 200 ** Number(part("zoom").value);
      const mark = marks[0] + Number(part("middle").value) * (marks[last] - marks[0]);
      said("time", frame.label);
      said("magnification", `${shown(magnified)} times`);
      said("zoom", `${shown(zoom)} times`);
      said("middle", `${shown(mark)} ${data.unit}`);
      // the whole is in the middle at first; the point one looks at comes there as one zooms in
      const near = 1 - 1 / zoom, middle = on_guide(mark).map((at, i) => whole[i] + near * (at - whole[i]));
      const ca = Math.cos(turn.azimuth), sa = Math.sin(turn.azimuth), cl = Math.cos(turn.lift), sl = Math.sin(turn.lift);
      const flat = (x, y, z) => {
        const a = x - middle[0], b = y - middle[1], c = z - middle[2];
        return [sa * a + ca * b, cl * c - sl * (ca * a - sa * b)];
      };
      const scale = zoom * fit(flat, width, height);
      const place = (x, y, z) => { // the first axis into the picture, the second to the right, the third down
        const [right, down] = flat(x, y, z);
        return [width / 2 + scale * right, height / 2 + scale * down];
      };

      pen.strokeStyle = faint;
      pen.lineWidth = 1;
      draw_box(place);
      pen.strokeStyle = pen.fillStyle = muted;
      pen.beginPath();
      for (let k = 0; k <= last; ++k) pen.lineTo(...place(data.guide[0][k], data.guide[1][k], data.guide[2][k]));
      pen.stroke();
      const step = round_step((marks[last] - marks[0]) / zoom, 8);
      for (let m = Math.ceil(marks[0] / step) * step; m <= marks[last]; m += step) {
        const [x, y] = place(...on_guide(m));
        if (x < 0 || x > width || y < 0 || y > height) continue;
        pen.fillRect(x - 2, y - 2, 4, 4);
        pen.fillText(`${shown(m)} ${data.unit}`, x + 9, y + 4);
      }
      const [x, y, z] = frame.line, [dx, dy, dz] = frame.shift, values = frame.values[which], more = magnified - 1;
      const points = x.map((_, k) => place(x[k] + more * dx[k], y[k] + more * dy[k], z[k] + more * dz[k]));
      pen.lineWidth = 3.5;
      for (let k = 0; k + 1 < points.length; ++k) {
        pen.strokeStyle = colour_at((0.5 * (values[k] + values[k + 1]) - low) / (high - low));
        pen.beginPath();
        pen.moveTo(...points[k]);
        pen.lineTo(...points[k + 1]);
        pen.stroke();
      }
      draw_colours(low, high, data.names[which]);
      draw_scale(scale, width, height);
    }

    // pixels a unit, so that the whole box fits
    function fit(flat, width, height) {
      const corners = [0, 1, 2, 3, 4, 5, 6, 7].map((k) => flat(box[0][k & 1], box[1][(k >> 1) & 1], box[2][k >> 2]));
      const [wide, tall] = [0, 1].map((i) => Math.max(...corners.map((c) => c[i])) - Math.min(...corners.map((c) => c[i])));
      return Math.min((width - 150) / wide, (height - 110) / tall);
    }

    function draw_box(place) {
      const corner = (i, j, k) => place(box[0][i], box[1][j], box[2][k]);
      for (const [a, b] of [[0, 0], [0, 1], [1, 0], [1, 1]]) {
        for (const ends of [[corner(0, a, b), corner(1, a, b)], [corner(a, 0, b), corner(a, 1, b)], [corner(a, b, 0), corner(a, b, 1)]]) {
          pen.beginPath();
          pen.moveTo(...ends[0]);
          pen.lineTo(...ends[1]);
          pen.stroke();
        }
      }
      pen.fillStyle = muted;
      // an axis has its name at the end of an edge, away from the middle of the box
      const centre = place(...box.map(([low, high]) => 0.5 * (low + high)));
      const name = (text, at) => {
        const left = at[0] < centre[0];
        pen.textAlign = left ? "right" : "left";
        pen.fillText(text, at[0] + (left ? -8 : 8), at[1] + (at[1] < centre[1] ? -4 : 14));
      };
      name(data.axes[0], corner(1, 1, 1));
      name(data.axes[1], corner(0, 1, 1));
      name(data.axes[2], corner(1, 1, 0));
      pen.textAlign = "left";
    }

    function draw_colours(low, high, name) {
      const wide = 150, tall = 10, left = 12, top = 28;
      for (let i = 0; i < wide; ++i) {
        pen.fillStyle = colour_at(i / (wide - 1));
        pen.fillRect(left + i, top, 1.5, tall);
      }
      pen.fillStyle = ink;
      pen.fillText(name, left, top - 8);
      pen.fillText(shown(low), left, top + tall + 16);
      pen.textAlign = "right";
      pen.fillText(shown(high), left + wide, top + tall + 16);
      pen.textAlign = "left";
    }

    function draw_scale(scale, width, height) {
      const length = round_step(0.25 * width / scale, 1.0001), left = 12, bottom = height - 12;
      pen.strokeStyle = pen.fillStyle = ink;
      pen.lineWidth = 2;
      pen.beginPath();
      pen.moveTo(left, bottom);
      pen.lineTo(left + scale * length, bottom);
      pen.stroke();
      pen.fillText(`${length.toLocaleString("en")} ${data.unit}`, left, bottom - 8);
    }

    let held = null;
    canvas.addEventListener("pointerdown", (event) => {
      held = [event.clientX, event.clientY];
      canvas.setPointerCapture(event.pointerId);
    });
    canvas.addEventListener("pointermove", (event) => {
      if (!held) return;
      turn.azimuth += 0.008 * (event.clientX - held[0]);
      turn.lift = Math.min(Math.max(turn.lift + 0.008 * (event.clientY - held[1]), -1.57), 1.57);
      held = [event.clientX, event.clientY];
      draw();
    });
    for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, () => { held = null; });

    let playing = null;
    function stop() {
      clearInterval(playing);
      playing = null;
      part("play").textContent = "play";
    }
    part("play").addEventListener("click", () => {
      if (playing) return stop();
      const slider = part("time"), step = 1 / Math.max(data.frames.length - 1, 1);
      if (Number(slider.value) > 1 - 0.5 * step) slider.value = 0;
      part("play").textContent = "stop";
      playing = setInterval(() => {
        slider.value = Math.min(Number(slider.value) + step, 1);
        draw();
        if (Number(slider.value) > 1 - 0.5 * step) stop();
      }, 120);
    });
    part("reset").addEventListener("click", () => { stop(); reset(); draw(); });
    for (const control of view.querySelectorAll("input, select")) control.addEventListener("input", draw);
    new ResizeObserver(draw).observe(canvas);
    reset();
    draw();
  }

  document.querySelectorAll(".space").forEach(start);
})();
