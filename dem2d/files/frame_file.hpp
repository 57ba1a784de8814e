#pragma once
/// The part of a run file that shows all discs at some instants (docs/reference/formats.md, "run.h5", `/frames`). Every
/// run has the end of the cut; one made with `cut --frames N` has N instants, the last of them the end, with velocities
/// and bonded joints. Frames are numbered from 0.

#include <vector>

#include "base/hdf5_file.hpp"
#include "dem2d/cut/run_cut.hpp"

namespace bitrock::dem2d {

/// As `/frames/0000` and so on, the last one as `/frames/last`.
void write_frames(base::Hdf5Writer& file, const std::vector<Frame>& frames);

/// How many discs the bed had, attribute `discs`.
int born_discs(const base::Hdf5Reader& file);

/// How many frames a run file holds; at least one.
int count_frames(const base::Hdf5Reader& file);

/// One frame of a run file; read one at a time, a long animation need not fit into memory. Throws `base::InputError`
/// when there is no such frame, or what it holds is impossible.
Frame read_frame(const base::Hdf5Reader& file, int number);

}  // namespace bitrock::dem2d
