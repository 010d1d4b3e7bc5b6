# Runs at installation: copies the headers of `rooms` from `source` to fpkcheck/ROOM below `destination`, and changes
# their includes of each other to this path.
string(RANDOM LENGTH 8 unique)  # for concurrent installations
string(APPEND staged "-${unique}")
foreach(room IN LISTS rooms)
  file(GLOB_RECURSE headers RELATIVE "${source}" "${source}/${room}/*.hpp")
  foreach(header IN LISTS headers)
    file(READ "${source}/${header}" text)
    string(REGEX REPLACE "#include \"(${any_room})/" "#include \"fpkcheck/\\1/" text "${text}")
    file(WRITE "${staged}/fpkcheck/${header}" "${text}")
  endforeach()
endforeach()
if(NOT IS_ABSOLUTE "${destination}")
  set(destination "${CMAKE_INSTALL_PREFIX}/${destination}")
endif()
file(INSTALL DESTINATION "${destination}" TYPE DIRECTORY FILES "${staged}/fpkcheck")
file(REMOVE_RECURSE "${staged}")
