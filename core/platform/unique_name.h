#pragma once
// Names for temporary files and folders, on disks that several machines may share.

#include <string>
#include <string_view>

namespace weftlight::platform {

/// 64 random bits as 16 hexadecimal digits.
std::string unique_name();
bool is_unique_name(std::string_view name);

/// A unique name beside `path`, on any machine, with the same extension: "STEM.part-RANDOM.EXT". The file is locked
/// (file_lock.h) while its owner lives; only that tells what a killed process left.
std::string temporary_beside(const std::string& path);
/// Whether `name`, without its folder, is one that temporary_beside(path) gives.
bool is_temporary_of(const std::string& path, const std::string& name);
/// Whether it is one that temporary_beside() gives for any path.
bool is_temporary(const std::string& name);

}  // namespace weftlight::platform
