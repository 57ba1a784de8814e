# Writes the commit that a build is made from into a source file, at build time, and only when it has changed:
#
#   cmake -DSOURCE=<source tree> -DTEMPLATE=<file.in> -DOUTPUT=<file> -DVERSION=<x.y.z> -P commit.cmake
#
# In a checkout it is that of HEAD, with `-dirty` when files differ from it. In an archive (git archive, the archives of
# a forge) git has put the commit into archived_commit.txt (.gitattributes: export-subst); what was changed after
# unpacking is not known there. A tree that lies inside another repository does not take that one's commit.
find_program(GIT git)
set(commit "")
if(GIT AND EXISTS "${SOURCE}/.git")
  # safe.directory: a build in a container, or by root, may read a checkout of somebody else.
  execute_process(COMMAND "${GIT}" -c "safe.directory=${SOURCE}" -C "${SOURCE}" describe --always --dirty --abbrev=12
                          --exclude=*
                  OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
if(commit STREQUAL "")
  file(STRINGS "${SOURCE}/cmake/archived_commit.txt" archived LIMIT_COUNT 1)
  if(EXISTS "${SOURCE}/.git")
    set(commit "unknown: git does not tell")
  elseif(archived MATCHES "^[0-9a-f]+$")
    string(SUBSTRING "${archived}" 0 12 commit)
    string(APPEND commit ", from an archive")
  else()
    set(commit "unknown: built from an archive")
  endif()
endif()
set(BITROCK_GIT_COMMIT "${commit}")
set(BITROCK_VERSION "${VERSION}")
configure_file("${TEMPLATE}" "${OUTPUT}" @ONLY)
