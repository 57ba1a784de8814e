#!/bin/sh
# The rule must catch what it is for.
set -eu
rule=$(dirname "$0")/numbers.sh
house=$(mktemp -d)
trap 'rm -rf "$house"' EXIT
for module in base cli dem2d peaks python report runtime studies surrogate views; do mkdir "$house/$module"; done
echo 'double a = *base::number_in(text), history(1), restore(2);' >"$house/cli/good.cpp"
"$rule" "$house"
for bad in 'std::sscanf(text, "%d", &n);' 'x = atof(text);' 'x = std::strtod(text, nullptr);' 'x = std::stod(text);' \
  'n = std::stoi (text);' 'CLI::detail::lexical_cast(text, x);' 'const auto j = nlohmann::json::parse(text);'; do
  printf '%s\n' "$bad" >"$house/dem2d/bad.cpp"
  if "$rule" "$house" >/dev/null; then
    echo "not caught: $bad"
    exit 1
  fi
done
