// Triangle meshes from files: OBJ, STL and PLY.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "solver/objects/mesh.hpp"

namespace sandsim {

/// What is odd about a file and was left out or passed over: "file:line:col: what".
using Warnings = std::vector<std::string>;

/// Reads a mesh; the extension tells the format: .obj, .stl or .ply. Coordinates are as the file has them. Polygons are
/// cut into triangles; vertices that no face uses are kept, at the origin if they are not finite. `warnings` may be
/// null. Numbers that have no part in the surface are not looked at.
/// Throws InputError: "file:line:col: problem" for text and "file: byte N: problem" for binary files. Every index is in
/// range, every coordinate finite, and there is a triangle at least. Memory is taken for what a file holds, not for
/// what it announces.
objects::TriangleMesh read_mesh(const std::filesystem::path& path, Warnings* warnings = nullptr);

// The same from memory; `name` stands for the file.

/// Wavefront OBJ: v and f (v, v/vt, v//vn, v/vt/vn; negative indices count back from the face, others may come before
/// their vertex). Curves, lines, points and statements without geometry are skipped, others are errors.
objects::TriangleMesh read_obj(std::string_view text, const std::string& name, Warnings* warnings = nullptr);
/// STL: binary if its length is the 84 + 50 n bytes that it announces, else ASCII if it starts with "solid". Normals
/// are not read.
objects::TriangleMesh read_stl(std::string_view bytes, const std::string& name, Warnings* warnings = nullptr);
/// PLY 1.0: ASCII or binary of either byte order; x, y, z of `vertex`, and vertex_indices (or vertex_index) of `face`
/// and of `tristrips`.
objects::TriangleMesh read_ply(std::string_view bytes, const std::string& name, Warnings* warnings = nullptr);

}  // namespace sandsim
