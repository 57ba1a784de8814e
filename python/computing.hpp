#pragma once
/// Long computations called from Python. The work runs in a thread of its own, without the interpreter's lock, so other
/// Python threads go on. The thread of the call looks after it: a few times a second it tells the listener how far the
/// work is and asks the interpreter for Ctrl-C. Python code runs in the thread of the call alone.

#include <pybind11/pybind11.h>

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/progress.hpp"

namespace bitrock::python {

/// What the progress is of, for the line of `progress=True`: shown number = number of the work times `per_unit`.
struct Label {
  const char* work;
  const char* unit;
  double per_unit = 1.0;
};

/// `progress` as the caller gave it: None or False (nobody listens), True (a line on sys.stderr), or a function of
/// (done, total). An exception of that function stops the work and is raised; so is KeyboardInterrupt. A stop is for
/// all computations under way in this process.
void run_beside(const pybind11::object& progress, const Label& label,
                const std::function<void(const base::ProgressCallback&)>& work);

/// The same for work with a result.
template <class Work>
auto computed(const pybind11::object& progress, const Label& label, const Work& work) {
  std::optional<decltype(work(base::ProgressCallback{}))> result;
  run_beside(progress, label, [&](const base::ProgressCallback& listener) { result.emplace(work(listener)); });
  return std::move(*result);
}

/// As Python warnings of the category BitrockWarning, at the line of the caller.
void warn(const std::vector<std::string>& warnings);

}  // namespace bitrock::python
