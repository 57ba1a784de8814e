#include "dem2d/files/frame_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"

namespace bitrock::dem2d {

namespace {

std::string group_of(int number, int count) {
  return number == count - 1 ? "/frames/last" : fmt::format("/frames/{:04d}", number);
}

/// Seven digits are enough to look at, and the zeros that follow compress to nothing.
std::vector<double> rounded_to_single(const std::vector<double>& values) {
  std::vector<double> rounded;
  rounded.reserve(values.size());
  for (const double value : values) rounded.push_back(static_cast<double>(static_cast<float>(value)));
  return rounded;
}

void write_frame(base::Hdf5Writer& file, const std::string& group, const Frame& frame) {
  file.array(group + "/time_s", std::vector<double>{frame.time}, "s", "instant of the frame");
  file.array(group + "/tip_x_m", std::vector<double>{frame.tip_x}, "m", "cutter tip along the surface");
  file.array(group + "/x_m", frame.x, "m", "disc centre");
  file.array(group + "/y_m", frame.y, "m", "disc centre");
  file.array(group + "/radius_m", frame.radius, "m", "disc radius");
  file.array(group + "/id", frame.id, "1", "number the disc was born with");
  file.array(group + "/fragment", frame.fragment, "1", "piece the disc hangs together with, 0 is the bed");
  if (frame.velocity_x.empty()) return;
  file.array(group + "/velocity_x_m_per_s", rounded_to_single(frame.velocity_x), "m/s", "half a step before time_s");
  file.array(group + "/velocity_y_m_per_s", rounded_to_single(frame.velocity_y), "m/s", "half a step before time_s");
  file.array(group + "/joint_disc_1", frame.joint_disc1, "1", "id of the first disc of each bonded joint");
  file.array(group + "/joint_disc_2", frame.joint_disc2, "1", "id of the second disc of each bonded joint");
}

double single_number(const base::Hdf5Reader& file, const std::string& path) {
  const std::vector<double> values = file.doubles(path);
  if (values.size() != 1 || !std::isfinite(values[0]))
    throw base::InputError(fmt::format("{}: {} must be one finite number", file.name(), path));
  return values[0];
}

/// Throws `base::InputError` unless the frame can be drawn. Every number of discs is below `born`.
void check_frame(const Frame& frame, int born, const std::string& where) {
  const auto refuse = [&where](const std::string& why) { throw base::InputError(where + ": " + why); };
  const std::size_t discs = frame.x.size();
  for (const std::size_t size : {frame.y.size(), frame.radius.size(), frame.id.size(), frame.fragment.size()}) {
    if (size != discs) refuse("arrays differ in length");
  }
  for (const std::vector<double>* velocity : {&frame.velocity_x, &frame.velocity_y}) {
    if (!velocity->empty() && velocity->size() != discs) refuse("velocities differ in number from the discs");
  }
  if (frame.joint_disc1.size() != frame.joint_disc2.size()) refuse("joint arrays differ in length");
  for (const std::vector<double>* values : {&frame.x, &frame.y, &frame.radius, &frame.velocity_x, &frame.velocity_y}) {
    if (!std::all_of(values->begin(), values->end(), [](double value) { return std::isfinite(value); }))
      refuse("a position, radius or velocity is not a finite number");
  }
  if (!std::all_of(frame.radius.begin(), frame.radius.end(), [](double radius) { return radius > 0.0; }))
    refuse("a radius is not above 0");
  const auto possible = [born](int number) { return number >= 0 && number < born; };
  for (const std::vector<int>* numbers : {&frame.id, &frame.fragment, &frame.joint_disc1, &frame.joint_disc2}) {
    if (!std::all_of(numbers->begin(), numbers->end(), possible))
      refuse(fmt::format("the number of a disc or fragment is not from 0 to {}", born - 1));
  }
  std::vector<bool> there(static_cast<std::size_t>(born), false);
  for (const int id : frame.id) there[static_cast<std::size_t>(id)] = true;
  for (const std::vector<int>* ends : {&frame.joint_disc1, &frame.joint_disc2}) {
    for (const int id : *ends) {
      if (!there[static_cast<std::size_t>(id)]) refuse(fmt::format("a joint names disc {}, which is not there", id));
    }
  }
}

}  // namespace

void write_frames(base::Hdf5Writer& file, const std::vector<Frame>& frames) {
  const int count = static_cast<int>(frames.size());
  for (int k = 0; k < count; ++k) write_frame(file, group_of(k, count), frames[static_cast<std::size_t>(k)]);
}

int born_discs(const base::Hdf5Reader& file) {
  return static_cast<int>(file.integer_attribute("discs", 1, static_cast<long long>(most_discs)));
}

int count_frames(const base::Hdf5Reader& file) {
  int count = 1;
  while (file.has(group_of(count - 1, count + 1))) ++count;
  return count;
}

Frame read_frame(const base::Hdf5Reader& file, int number) {
  const int count = count_frames(file);
  if (number < 0 || number >= count) {
    throw base::InputError(
        count == 1 ? fmt::format("{}: no frame {} (the run holds only frame 0, the end of the cut; for more, make it "
                                 "with `bitrock cut --frames N`)",
                                 file.name(), number)
                   : fmt::format("{}: no frame {} (the run holds frames 0 to {}, the last is the end of the cut)",
                                 file.name(), number, count - 1));
  }
  const std::string group = group_of(number, count);
  Frame frame{.time = single_number(file, group + "/time_s"),
              .tip_x = single_number(file, group + "/tip_x_m"),
              .x = file.doubles(group + "/x_m"),
              .y = file.doubles(group + "/y_m"),
              .radius = file.doubles(group + "/radius_m"),
              .id = file.ints(group + "/id"),
              .fragment = file.ints(group + "/fragment")};
  if (file.has(group + "/velocity_x_m_per_s")) {
    frame.velocity_x = file.doubles(group + "/velocity_x_m_per_s");
    frame.velocity_y = file.doubles(group + "/velocity_y_m_per_s");
    frame.joint_disc1 = file.ints(group + "/joint_disc_1");
    frame.joint_disc2 = file.ints(group + "/joint_disc_2");
  }
  check_frame(frame, born_discs(file), fmt::format("{} ({})", file.name(), group));
  return frame;
}

}  // namespace bitrock::dem2d
