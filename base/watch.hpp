#pragma once
/// Looks after the program while a command works, so that no command has to: when nothing has been printed for a while
/// it says that the work goes on, and when the user stops the program (Ctrl-C, SIGTERM, a terminal that closes) it ends
/// within a second, wherever it is. A command that looks at the stop by itself (`throw_if_stopped`) ends sooner
/// and can say what it keeps. One that does not (a large file being read, a picture being drawn) is ended from here:
/// programs that it has started are ended, files that are not whole are removed.

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace bitrock::base {

inline constexpr int interrupted = 130;  // exit status after Ctrl-C, by the custom of shells

/// One in `main`.
class Watch {
 public:
  Watch();
  ~Watch();
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;
  /// From then on the caller ends the program.
  void end();

 private:
  void look_after();

  std::mutex mutex_;
  std::condition_variable ended_;
  bool over_ = false;
  std::thread thread_;
};

/// What is at work, for the line that says so ("bitrock cut"); empty for a command that is to be quiet.
void at_work(const std::string& what);

}  // namespace bitrock::base
