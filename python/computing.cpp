#include "python/computing.hpp"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

#include "base/stop.hpp"

namespace py = pybind11;

namespace bitrock::python {

namespace {

constexpr std::chrono::milliseconds between_looks{50};

/// Computations under way. A stop lasts until the last of them has ended.
class UnderWay {
 public:
  UnderWay() {
    const std::lock_guard lock(mutex());
    ++count();
  }
  ~UnderWay() {
    const std::lock_guard lock(mutex());
    if (--count() == 0) base::stop_requested() = false;
  }
  UnderWay(const UnderWay&) = delete;
  UnderWay& operator=(const UnderWay&) = delete;

 private:
  static std::mutex& mutex() {
    static std::mutex only;
    return only;
  }
  static int& count() {
    static int computations = 0;
    return computations;
  }
};

/// What the thread of the work and the thread of the call share.
struct Shared {
  std::mutex mutex;
  std::condition_variable changed;
  bool over = false;
  bool fresh = false;  ///< told since the last look
  double done = 0.0, total = 0.0;
  std::exception_ptr failed;
};

class Listener {
 public:
  Listener(const py::object& progress, const Label& label) {
    if (progress.is_none() || progress.is(py::bool_(false))) return;
    if (progress.is(py::bool_(true))) {
      line_ = py::module_::import("bitrock._progress").attr("Line")(label.work, label.unit, label.per_unit);
      tell_ = line_.attr("show");
      return;
    }
    if (PyCallable_Check(progress.ptr()) == 0) {
      throw py::type_error("progress: " + std::string(py::str(py::type::of(progress).attr("__name__"))) +
                           " (must be True, None or a function of done and total)");
    }
    tell_ = progress;
  }
  explicit operator bool() const { return static_cast<bool>(tell_); }
  void tell(double done, double total) const { tell_(done, total); }
  void close() const {
    if (line_) line_.attr("close")();
  }

 private:
  py::object tell_, line_;
};

/// Waits for the end of the work, or for something to look at; true at the end. `told`: what there is to tell.
bool wait(Shared& shared, std::optional<std::pair<double, double>>& told) {
  const py::gil_scoped_release free;
  std::unique_lock lock(shared.mutex);
  shared.changed.wait_for(lock, between_looks, [&shared] { return shared.over; });
  if (std::exchange(shared.fresh, false)) told = {shared.done, shared.total};
  return shared.over;
}

void look_after(Shared& shared, const Listener& listener) {
  for (bool over = false; !over;) {
    std::optional<std::pair<double, double>> told;
    over = wait(shared, told);
    if (told && listener && !(over && shared.failed)) listener.tell(told->first, told->second);
    if (!over && PyErr_CheckSignals() != 0) throw py::error_already_set();
  }
}

}  // namespace

void run_beside(const py::object& progress, const Label& label,
                const std::function<void(const base::ProgressCallback&)>& work) {
  const Listener listener(progress, label);
  const UnderWay under_way;
  Shared shared;
  const auto take = [&shared](double done, double total) {
    const std::lock_guard lock(shared.mutex);
    shared.done = done;
    shared.total = total;
    shared.fresh = true;
  };
  std::thread thread([&] {
    std::exception_ptr failed;
    try {
      work(take);
    } catch (...) {
      failed = std::current_exception();
    }
    const std::lock_guard lock(shared.mutex);
    shared.failed = failed;
    shared.over = true;
    shared.changed.notify_all();
  });
  const auto join = [&thread] {
    const py::gil_scoped_release free;
    thread.join();
  };
  try {
    look_after(shared, listener);
  } catch (...) {
    base::stop_requested() = true;
    join();
    listener.close();
    throw;
  }
  join();
  listener.close();
  if (shared.failed) std::rethrow_exception(shared.failed);
}

void warn(const std::vector<std::string>& warnings) {
  const py::object category = py::module_::import("bitrock").attr("BitrockWarning");
  for (const std::string& warning : warnings) {
    if (PyErr_WarnEx(category.ptr(), warning.c_str(), 1) != 0) throw py::error_already_set();
  }
}

}  // namespace bitrock::python
