# The plot library, from npm at configure time, in the version and with the checksum of package-lock.json. It is fetched
# once per build directory and again only when the lock changes. Sets BITROCK_PLOTLY_DIR, empty when it cannot be had:
# everything else then still builds, and only reports are left out.
option(BITROCK_REPORT "carry the plot library (from npm), so that bitrock can write interactive reports" ON)

function(bitrock_fetch_plotly result)
  set(${result} "" PARENT_SCOPE)
  set(from ${CMAKE_CURRENT_SOURCE_DIR}/plotly)
  set(into ${CMAKE_CURRENT_BINARY_DIR}/plotly)
  set(package ${into}/node_modules/plotly.js-basic-dist-min)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${from}/package.json ${from}/package-lock.json)

  # The stamp is written last: a fetch that was cut off is done again.
  file(SHA256 ${from}/package-lock.json wanted)
  set(fetched "")
  if(EXISTS ${into}/fetched AND EXISTS ${package}/plotly-basic.min.js AND EXISTS ${package}/LICENSE)
    file(READ ${into}/fetched fetched)
  endif()
  if(fetched STREQUAL wanted)
    set(${result} ${package} PARENT_SCOPE)
    return()
  endif()

  find_program(BITROCK_NPM npm DOC "package manager of Node.js, fetches the plot library of the reports")
  if(NOT BITROCK_NPM)
    message(WARNING "reports are left out: npm not found (apt-get install npm)")
    return()
  endif()
  message(STATUS "Fetching the plot library of the reports with npm")
  file(REMOVE ${into}/fetched)
  file(COPY ${from}/package.json ${from}/package-lock.json DESTINATION ${into})
  execute_process(COMMAND ${BITROCK_NPM} ci --ignore-scripts --no-audit --no-fund --prefer-offline --fetch-retries=1
                  WORKING_DIRECTORY ${into} TIMEOUT 180
                  RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(NOT status EQUAL 0 OR NOT EXISTS ${package}/plotly-basic.min.js)
    message(WARNING "reports are left out: npm could not fetch the plot library (is the package registry reachable?). "
                    "npm said:\n${said}")
    return()
  endif()
  file(WRITE ${into}/fetched ${wanted})
  set(${result} ${package} PARENT_SCOPE)
endfunction()

set(BITROCK_PLOTLY_DIR "")
if(BITROCK_REPORT)
  bitrock_fetch_plotly(BITROCK_PLOTLY_DIR)
else()
  message(STATUS "Reports are left out: BITROCK_REPORT is OFF")
endif()
