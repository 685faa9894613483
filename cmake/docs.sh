#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds the docs as a site, build/docs/index.html, and the pages of the code beside it. Any warning is an error, and so
# is a claim without its test, or a comment that names an equation that is not there.
#
#   cmake/docs.sh [--build DIR]      what is built lies below DIR; else below build. The program must have been built
#                                    there: it prints the deck's reference
set -euo pipefail
project=$(cd "$(dirname "$0")/.." && pwd)
build=$project/build
case ${1:-} in
  "") ;;
  --build) build=$(cd "$2" && pwd) ;;
  *) sed -n '3,7s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
esac

bash "$project/cmake/install_dependencies.sh" docs
python3 "$project/cmake/check_claims.py"
python3 "$project/cmake/check_equations.py"

stroma=$build/release/bin/stroma
site=$build/docs
stage=$build/docs.stage
rm -rf "$site" "$stage"
mkdir -p "$site" "$stage/docs"

# The stage: the repository's pages where they are, with the generated ones beside them. In these, a parameter's
# meaning stands on a line of its own.
ln -s "$project"/*.md "$project"/LICENSE "$project"/{cmake,input_decks,packages,src,tests} "$stage"
ln -s "$project"/docs/* "$stage/docs"
{
  printf '# Deck reference\n\nEverything that a deck may say, as `stroma reference` prints it.\n\n'
  "$stroma" reference | sed '/^- `/s/$/\\/'
} >"$stage/docs/deck_reference.md"
{
  printf '# Study reference\n\nEverything that the deck of a study may say, as `stroma reference Study` prints it.\n\n'
  "$stroma" reference Study | sed '/^- `/s/$/\\/'
} >"$stage/docs/study_reference.md"
{
  printf '# Fit reference\n\nEverything that the deck of a fit may say, as `stroma reference Fit` prints it.\n\n'
  "$stroma" reference Fit | sed '/^- `/s/$/\\/'
} >"$stage/docs/fit_reference.md"
cat >"$stage/docs/api.md" <<END
# The code, page by page

Made by Doxygen from the comments of the packages' headers:
<a href="../api/namespaces.html">packages</a>, <a href="../api/annotated.html">classes</a>, <a href="../api/files.html">files</a>.
END

sphinx-build -q -W --keep-going -b html -c "$project/docs/site" -d "$stage/.doctrees" "$stage" "$site"
ln -s "$project/packages" "$stage/stroma"
(cd "$stage" && { cat docs/site/Doxyfile; echo "OUTPUT_DIRECTORY = $site"; } | doxygen -)
cp "$site/README.html" "$site/index.html"
rm -rf "$stage"
echo "docs: $site/index.html"
