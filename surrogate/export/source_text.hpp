#pragma once
/// What the writers of source text share: numbers that a compiler reads back bit for bit, and words of the model (the
/// name of the rock, of a data file) that can end no comment and no string, whatever is in them.

#include <string>
#include <string_view>

#include "surrogate/export/columns.hpp"
#include "surrogate/net/model.hpp"

namespace bitrock::surrogate {

/// Shortest decimal text that reads back to the same bits, with a point or an exponent, so that it is no whole number.
std::string number_text(double value);

/// Printable ASCII in one line: anything else becomes '_', and so do the signs that begin or end comments, continue a
/// line or make trigraphs: * / ? \ % { }.
std::string comment_text(std::string_view words);

/// Throws `base::InputError` unless `name` is an identifier that any compiler takes as the begin of longer ones:
/// letters, digits and single underscores, a letter first, no underscore last, at most `longest` characters. `what`
/// says which name it is.
void require_identifier(std::string_view name, std::string_view what, std::size_t longest);

/// One line on a column: name, meaning, training range.
std::string described(const Column& column);

/// What wrote the file and where its numbers come from, in three lines that each begin with `margin`.
std::string origin(const Model& model, std::string_view margin);

/// `text` with each `from` replaced.
std::string replaced(std::string text, std::string_view from, std::string_view to);

}  // namespace bitrock::surrogate
