#pragma once

#include <map>
#include <string>
#include <string_view>

namespace pendular {

/// Whether bytes are the beginning of a compound file, the container of old workbooks (.xls).
bool is_compound_file(std::string_view bytes);

/// Returns the streams of a compound file that are in no folder of it, by name; names have their
/// ASCII characters only, in capitals, since such files compare names without case. Streams that
/// the file does not hold whole end where it ends.
/// Source: Microsoft, Compound File Binary File Format, MS-CFB.
std::map<std::string, std::string> streams_of(std::string_view bytes);

}  // namespace pendular
