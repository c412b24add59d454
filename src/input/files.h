// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace tool {

/// Throws a `Refusal` if the file does not exist, is not a regular file, is empty or cannot be opened. Nothing is known
/// about the standard input, "-".
void check_readable(const std::string& file);

/// All bytes of a file, or of the standard input. Throws a `Refusal`.
std::string read_file(const std::string& file);

/// Its first bytes, `size` at most. Throws a `Refusal`.
std::string read_beginning(const std::string& file, std::size_t size);

/// Where a file is, or would be: from the root, without links. An empty name is that of the current folder.
std::filesystem::path place_of(const std::filesystem::path& file);

/// Whether the name of a file is `beginning`, digits, and `end`.
bool is_numbered(const std::string& file, const std::string& beginning, const std::string& end);

/// The files of such names that are there.
std::vector<std::string> numbered_files(const std::string& beginning, const std::string& end);

/// As in ".off".
std::string lower_case_extension(const std::string& file);

/// Whether a file in a folder is a mesh by its name: one of a format that `read_mesh()` reads, and of GIFTI's and
/// FreeSurfer's files those that usually hold surfaces.
bool is_mesh_file(const std::string& file);

/// The formats, for messages.
inline const char* const mesh_extensions = "OFF, OBJ, PLY, STL, GIFTI, FreeSurfer, MNI, VTK and glTF";

/// `inputs`, and the lines of the text file `list`, if it is not empty, which may be a pipe. Throws a `Refusal`.
std::vector<std::string> named_inputs(const std::vector<std::string>& inputs, const std::string& list);

/// The mesh files that the user means, each once, in an order that depends on the names alone: `names` in their order,
/// folders replaced by all mesh files in them and in their subfolders that are not hidden, sorted by name. Files that
/// do not exist stay in the list. Throws a `Refusal`.
std::vector<std::string> list_meshes(const std::vector<std::string>& names);

} // namespace tool
