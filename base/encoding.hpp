#pragma once
/// Which bytes are text here: UTF-8, with or without the mark that some programs put first. Every reader of texts from
/// outside asks this before it looks for a line or a key, because in other encodings it would find others.

#include <string>
#include <string_view>

namespace bitrock::base {

/// The same bytes without a UTF-8 byte order mark at their beginning.
std::string_view without_byte_order_mark(std::string_view bytes);

/// Throws `InputError` that names the file and what its bytes are: UTF-16 or UTF-32, Latin-1 or Windows-1252, a file of
/// HDF5, ZIP or gzip, or a text with a NUL byte in it, with its line.
void require_utf8(std::string_view bytes, const std::string& file);

}  // namespace bitrock::base
