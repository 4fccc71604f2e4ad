# cmake -DSOURCE=<src folder> -DROOMS=<folders below it, joined by |> -DOUTPUT=<header> -P this: writes
# one hash over all files of the rooms, so that a kept truth never outlives the code that traced it.
cmake_minimum_required(VERSION 3.25)
string(REPLACE "|" ";" rooms "${ROOMS}")
list(TRANSFORM rooms REPLACE ".+" "${SOURCE}/\\0/*" OUTPUT_VARIABLE globs)
file(GLOB_RECURSE files RELATIVE ${SOURCE} ${globs})
set(all "")
foreach(file ${files})
    file(SHA256 "${SOURCE}/${file}" hash)
    string(APPEND all "${file} ${hash}\n")
endforeach()
string(SHA256 sources "${all}")
file(CONFIGURE OUTPUT "${OUTPUT}" CONTENT "#pragma once

namespace ink::truth {

inline constexpr char kSourcesHash[] = \"@sources@\";

}  // namespace ink::truth
" @ONLY)
