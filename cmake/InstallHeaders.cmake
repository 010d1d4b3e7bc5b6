# Runs at installation: copies the headers of `folders` from `source` to fpkcheck/FOLDER below `destination`, and changes
# their includes of each other to this path.
string(RANDOM LENGTH 8 unique)  # for concurrent installations
string(APPEND staged "-${unique}")
foreach(folder IN LISTS folders)
  file(GLOB_RECURSE headers RELATIVE "${source}" "${source}/${folder}/*.hpp")
  foreach(header IN LISTS headers)
    file(READ "${source}/${header}" text)
    string(REGEX REPLACE "#include \"(${any_folder})/" "#include \"fpkcheck/\\1/" text "${text}")
    file(WRITE "${staged}/fpkcheck/${header}" "${text}")
  endforeach()
endforeach()
if(NOT IS_ABSOLUTE "${destination}")
  set(destination "${CMAKE_INSTALL_PREFIX}/${destination}")
endif()
file(INSTALL DESTINATION "${destination}" TYPE DIRECTORY FILES "${staged}/fpkcheck")
file(REMOVE_RECURSE "${staged}")
