// SPDX-License-Identifier: GPL-3.0-or-later
// What is fuzzed. Every target makes its input from arbitrary bytes, and throws `Broken_promise` if what comes out
// breaks a promise of the documentation; crashes, leaks, hangs and undefined behaviour are for libFuzzer and the
// sanitizers to see. The same functions run over the kept inputs in the ordinary tests (test/test_fuzz_corpus.cpp).

#ifndef FUZZ_TARGETS_H
#define FUZZ_TARGETS_H

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace fuzz {

struct Broken_promise : std::logic_error {
  using std::logic_error::logic_error;
};

inline void promise(bool is_kept, const std::string& what)
{
  if(!is_kept)
    throw Broken_promise(what);
}

/// The first byte chooses the format, the others are the file: OFF, PLY, OBJ and STL as the tool reads them, and the
/// result as a sphere.
void read_meshes(const std::uint8_t* data, std::size_t size);

/// The same for GIFTI, GLB, glTF and FreeSurfer's format, and for compressed files of all formats.
void read_formats(const std::uint8_t* data, std::size_t size);

/// The first byte chooses the format, the second is the number of vertices: values and labels at vertices, and meshes
/// of VTK.
void read_data(const std::uint8_t* data, std::size_t size);

/// A damaged index of signatures, and the nearest neighbours in it.
void read_indices(const std::uint8_t* data, std::size_t size);

/// `parameterize()` on any mesh, with any coordinates, weights, fixed vertices, method and options.
void map_meshes(const std::uint8_t* data, std::size_t size);

/// Texture coordinates, segmentation, inverse map, signature and measures of any valid map of any source.
void use_maps(const std::uint8_t* data, std::size_t size);

} // namespace fuzz

#endif // FUZZ_TARGETS_H
