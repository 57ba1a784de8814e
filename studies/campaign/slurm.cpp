#include "studies/campaign/slurm.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "base/child_process.hpp"
#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/number.hpp"
#include "base/progress.hpp"

namespace bitrock::studies {

namespace {

using Path = std::filesystem::path;

constexpr double signal_seconds = 60.0;  // before its time is over a task is told to end

/// A path that can stand in a script: in one line, which begins no other.
std::string checked(const Path& path) {
  std::string text = path.string();
  const bool good = std::none_of(text.begin(), text.end(), [](char c) { return (c >= 0 && c < ' ') || c == 127; });
  if (!good) {
    throw base::InputError(
        fmt::format("{}: a path with a control character or a new line cannot be given to Slurm", text));
  }
  return text;
}

/// For the shell.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

/// For a line of options, where Slurm knows double quotes and nothing to escape them.
std::string option_text(const Path& path) {
  const std::string text = checked(path);
  if (text.find_first_of("\"\\") != std::string::npos)
    throw base::InputError(fmt::format("{}: a path with a quote or a backslash cannot be given to Slurm", text));
  return '"' + text + '"';
}

std::string header(const std::string& what, const std::string& name, const Path& folder, const SlurmOptions& options) {
  std::string text = "#!/bin/bash\n# " + what + "\n";
  const auto option = [&text](const std::string& line) { text += "#SBATCH --" + line + "\n"; };
  option("job-name=" + name);
  option("ntasks=1");
  option("cpus-per-task=1");
  option(fmt::format("mem={}M", options.memory_MB));
  if (!options.partition.empty()) option("partition=" + options.partition);
  option("chdir=" + option_text(folder));
  option("open-mode=append");
  option("requeue");
  return text;
}

/// With the study that the folder keeps: whatever becomes of the file it was read from, the tasks do the same work.
std::string command(const Path& program, const std::string& action, const Path& folder) {
  return fmt::format("exec {} campaign {} --dir {}", quoted(checked(program)), action, quoted(checked(folder)));
}

}  // namespace

double seconds_of(const std::string& time_limit) {
  double days = 0.0, seconds = 0.0;
  std::string clock = time_limit;
  if (const std::size_t dash = clock.find('-'); dash != std::string::npos) {
    days = base::number_in(clock.substr(0, dash)).value();
    clock.erase(0, dash + 1);
  }
  for (std::size_t at = 0; at < clock.size();) {
    const std::size_t end = std::min(clock.find(':', at), clock.size());
    seconds = 60.0 * seconds + base::number_in(clock.substr(at, end - at)).value();
    at = end + 1;
  }
  seconds += 86400.0 * days;
  return seconds > 0.0 ? seconds : std::numeric_limits<double>::infinity();
}

std::vector<std::string> warnings(const Plan& plan, const SlurmOptions& options, int tasks) {
  const double limit = seconds_of(options.time_limit) - signal_seconds;
  const int cuts = plan.jobs - plan.done;
  if (cuts == 0 || tasks == 0) return {};
  const std::string guess = fmt::format("at {:g} ns per disc and step", dem2d::typical_ns_per_disc_step);
  if (plan.longest_cut > limit) {
    return {fmt::format(
        "--time {} is too short for the longest cut, about {} {}: it is stopped {:.0f} s before the limit, however "
        "often it begins; give --time well above that",
        options.time_limit, base::readable_duration(plan.longest_cut), guess, signal_seconds)};
  }
  const double a_task = plan.core_time / std::min(cuts, tasks);
  if (a_task > limit) {
    return {fmt::format(
        "--time {} is too short for the cuts of one task, about {} in the mean {}: what is left then needs another "
        "submit; take more --tasks, or a longer --time",
        options.time_limit, base::readable_duration(a_task), guess)};
  }
  return {};
}

SlurmScripts write_slurm_scripts(const Study& study, const Path& folder, const Path& program,
                                 const SlurmOptions& options) {
  const int count = count_jobs(study);
  const Path where = std::filesystem::absolute(folder).lexically_normal();
  SlurmScripts scripts{.array = where / "slurm" / "array.sh",
                       .collect = where / "slurm" / "collect.sh",
                       .tasks = std::min({options.tasks > 0 ? options.tasks : count, count, most_tasks})};
  base::require_writable_folder(where / "slurm");

  std::string array = header(fmt::format("Written by bitrock campaign submit: {} cuts in {} tasks. By hand: sbatch "
                                         "array.sh, then sbatch --dependency=afterany:<its number> collect.sh",
                                         count, scripts.tasks),
                             "bitrock", where, options);
  array += fmt::format("#SBATCH --array=1-{}\n#SBATCH --output=slurm/task_%a.log\n", scripts.tasks);
  array += fmt::format("#SBATCH --signal=B:TERM@{:.0f}\n", signal_seconds);
  if (!options.time_limit.empty()) array += fmt::format("#SBATCH --time={}\n", options.time_limit);
  array +=
      fmt::format("{} --jobs 1 --shard \"$SLURM_ARRAY_TASK_ID/{}\"\n", command(program, "run", where), scripts.tasks);
  std::string collect = header("Written by bitrock campaign submit", "bitrock-collect", where, options);
  collect += "#SBATCH --output=slurm/collect.log\n" + command(program, "collect", where) + "\n";
  base::write_whole(scripts.array, array);
  base::write_whole(scripts.collect, collect);
  return scripts;
}

namespace {

/// The number of the submitted job.
std::string sbatch(const std::vector<std::string>& arguments) {
  if (!base::is_installed("sbatch")) {
    throw base::InputError(
        "sbatch is not there (submit where Slurm is installed; --dry-run writes the scripts without it)");
  }
  std::vector<std::string> call{"sbatch", "--parsable"};
  call.insert(call.end(), arguments.begin(), arguments.end());
  base::ProgramEnd end = base::run_program(call);
  std::string& said = end.output;
  while (!said.empty() && said.back() == '\n') said.pop_back();
  // the number stands in the last line, before the name of the cluster if there is one; warnings may come before it
  const std::string line = said.substr(said.rfind('\n') + 1);
  std::string number = line.substr(0, line.find(';'));
  const bool good = end.status == 0 && !number.empty() && number.find_first_not_of("0123456789") == std::string::npos;
  if (!good) throw base::InputError(fmt::format("Slurm refuses: {}", said));
  return number;
}

}  // namespace

SlurmJobs submit(const SlurmScripts& scripts) {
  SlurmJobs submitted{.array = sbatch({scripts.array.string()})};
  submitted.collect = sbatch({"--dependency=afterany:" + submitted.array, scripts.collect.string()});
  return submitted;
}

}  // namespace bitrock::studies
