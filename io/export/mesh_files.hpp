// Meshes and particles as files of other programs.
#pragma once

#include <string>

#include "io/output/series_frames.hpp"
#include "solver/surface/surface_mesh.hpp"

namespace sandsim {

// The bytes of a file, in metres. z points up.

/// PLY 1.0, binary, little-endian: x, y, z in float64, since float32 would blur coordinates of maps; nx, ny, nz.
std::string ply_bytes(const surface::SurfaceMesh& mesh);
/// Wavefront OBJ: v, vn and f; coordinates read back to the same bits.
std::string obj_text(const surface::SurfaceMesh& mesh);
/// VTK's XML PolyData with raw data appended: points in float64, their normals and `depth` over the ground.
std::string vtp_bytes(const surface::SurfaceMesh& mesh);
/// VTK's legacy PolyData, binary, which is big-endian; the same content.
std::string vtk_bytes(const surface::SurfaceMesh& mesh);

/// A point cloud: x, y, z in float64, and id likewise, since PLY's integers have 32 bits. Throws OutputError for ids
/// beyond 2^53, which float64 would round.
std::string ply_bytes(const VisibleParticles& particles);
/// PolyData with a vertex for each particle, and their `id` in 64 bits.
std::string vtp_bytes(const VisibleParticles& particles);

}  // namespace sandsim
