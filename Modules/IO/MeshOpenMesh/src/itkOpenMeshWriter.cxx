/*=========================================================================
 *
 *  Copyright The DentalSCR authors
 *
 *  Licensed under the Apache License, Version 2.0 (the "License");
 *  you may not use this file except in compliance with the License.
 *  You may obtain a copy of the License at
 *
 *         https://www.apache.org/licenses/LICENSE-2.0
 *
 *  Unless required by applicable law or agreed to in writing, software
 *  distributed under the License is distributed on an "AS IS" BASIS,
 *  WITHOUT WARRANTIES OR CONDITIONS OF ANY KIND, either express or implied.
 *  See the License for the specific language governing permissions and
 *  limitations under the License.
 *
 *=========================================================================*/
#include "itkOpenMeshWriter.h"

#include <OpenMesh/Core/IO/IOManager.hh>
#include <OpenMesh/Core/IO/exporter/BaseExporter.hh>
#include <OpenMesh/Core/Mesh/BaseKernel.hh>
#include <OpenMesh/Core/System/omstream.hh>

#include <locale>
#include <mutex>

namespace itk
{
namespace
{
using OpenMesh::EdgeHandle;
using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;
using OpenMesh::Attributes::StatusInfo;

/** Shows flat arrays to OpenMesh's writers. Not one of its meshes: those cannot hold faces that are not manifold. */
class FlatExporter : public OpenMesh::IO::BaseExporter
{
public:
  FlatExporter(const std::vector<std::array<float, 3>> &          points,
               const std::vector<SurfaceMeshFile::TriangleType> & triangles)
    : m_Points(points)
    , m_Triangles(triangles)
  {}

  OpenMesh::Vec3f
  point(VertexHandle vertex) const override
  {
    const std::array<float, 3> & p = m_Points[static_cast<std::size_t>(vertex.idx())];
    return { p[0], p[1], p[2] };
  }
  OpenMesh::Vec3d
  pointd(VertexHandle vertex) const override
  {
    return OpenMesh::Vec3d(this->point(vertex));
  }
  bool
  is_point_double() const override
  {
    return false;
  }
  unsigned int
  get_vhandles(FaceHandle face, std::vector<VertexHandle> & vertices) const override
  {
    vertices.clear();
    for (const std::uint32_t corner : m_Triangles[static_cast<std::size_t>(face.idx())])
    {
      vertices.emplace_back(static_cast<int>(corner));
    }
    return 3;
  }
  const OpenMesh::BaseKernel *
  kernel() override
  {
    // The PLY writer looks for custom properties here: there are none.
    return &m_Kernel;
  }
  size_t
  n_vertices() const override
  {
    return m_Points.size();
  }
  size_t
  n_faces() const override
  {
    return m_Triangles.size();
  }
  size_t
  n_edges() const override
  {
    return 0;
  }
  bool
  is_triangle_mesh() const override
  {
    return true;
  }

  // What is not written is never asked for.
  OpenMesh::Vec3f
  normal(VertexHandle) const override
  {
    return OpenMesh::Vec3f(0.0f);
  }
  OpenMesh::Vec3d
  normald(VertexHandle) const override
  {
    return OpenMesh::Vec3d(0.0);
  }
  bool
  is_normal_double() const override
  {
    return false;
  }
  OpenMesh::Vec3f
  normal(FaceHandle) const override
  {
    return OpenMesh::Vec3f(0.0f);
  }
  OpenMesh::Vec3d
  normald(FaceHandle) const override
  {
    return OpenMesh::Vec3d(0.0);
  }
  OpenMesh::Vec2f
  texcoord(VertexHandle) const override
  {
    return OpenMesh::Vec2f(0.0f);
  }
  OpenMesh::Vec2f
  texcoord(HalfedgeHandle) const override
  {
    return OpenMesh::Vec2f(0.0f);
  }
  unsigned int
  get_face_texcoords(std::vector<OpenMesh::Vec2f> &) const override
  {
    return 0;
  }
  HalfedgeHandle
  getHeh(FaceHandle, VertexHandle) const override
  {
    return HalfedgeHandle();
  }
  int
  get_halfedge_id(VertexHandle) override
  {
    return -1;
  }
  int
  get_halfedge_id(FaceHandle) override
  {
    return -1;
  }
  int
  get_next_halfedge_id(HalfedgeHandle) override
  {
    return -1;
  }
  int
  get_to_vertex_id(HalfedgeHandle) override
  {
    return -1;
  }
  int
  get_face_id(HalfedgeHandle) override
  {
    return -1;
  }
  StatusInfo
  status(HalfedgeHandle) const override
  {
    return {};
  }

#define itkFlatExporterAttributesMacro(Handle)    \
  OpenMesh::Vec3uc color(Handle) const override   \
  {                                               \
    return OpenMesh::Vec3uc(0);                   \
  }                                               \
  OpenMesh::Vec4uc colorA(Handle) const override  \
  {                                               \
    return OpenMesh::Vec4uc(0);                   \
  }                                               \
  OpenMesh::Vec3ui colori(Handle) const override  \
  {                                               \
    return OpenMesh::Vec3ui(0);                   \
  }                                               \
  OpenMesh::Vec4ui colorAi(Handle) const override \
  {                                               \
    return OpenMesh::Vec4ui(0);                   \
  }                                               \
  OpenMesh::Vec3f colorf(Handle) const override   \
  {                                               \
    return OpenMesh::Vec3f(0.0f);                 \
  }                                               \
  OpenMesh::Vec4f colorAf(Handle) const override  \
  {                                               \
    return OpenMesh::Vec4f(0.0f);                 \
  }                                               \
  StatusInfo status(Handle) const override        \
  {                                               \
    return {};                                    \
  }
  itkFlatExporterAttributesMacro(VertexHandle) itkFlatExporterAttributesMacro(EdgeHandle)
    itkFlatExporterAttributesMacro(FaceHandle)
#undef itkFlatExporterAttributesMacro

      private : const std::vector<std::array<float, 3>> & m_Points;
  const std::vector<SurfaceMeshFile::TriangleType> & m_Triangles;
  OpenMesh::BaseKernel                               m_Kernel;
};

/** OpenMesh's writers chat on its log; quiet while this lives. */
class QuietOpenMesh
{
public:
  QuietOpenMesh()
  {
    for (OpenMesh::mostream * stream : { &omlog(), &omout(), &omerr() })
    {
      stream->disable();
    }
  }
  ~QuietOpenMesh()
  {
    for (OpenMesh::mostream * stream : { &omlog(), &omout(), &omerr() })
    {
      stream->enable();
    }
  }
  QuietOpenMesh(const QuietOpenMesh &) = delete;
  QuietOpenMesh &
  operator=(const QuietOpenMesh &) = delete;
};
} // namespace
} // namespace itk

bool
DentalSCRWriteWithOpenMesh(std::ostream &                                          stream,
                           itk::MeshFileFormatEnum                                 format,
                           const std::vector<std::array<float, 3>> &               points,
                           const std::vector<itk::SurfaceMeshFile::TriangleType> & triangles,
                           bool                                                    binary)
{
  using namespace itk;
  // Its writers are singletons with state.
  static std::mutex                 mutex;
  const std::lock_guard<std::mutex> lock(mutex);
  const QuietOpenMesh               quiet;
  const char * const                extension = format == MeshFileFormatEnum::PLY   ? ".ply"
                                                : format == MeshFileFormatEnum::OBJ ? ".obj"
                                                : format == MeshFileFormatEnum::OFF ? ".off"
                                                                                    : ".stl";
  OpenMesh::IO::Options             options;
  if (binary)
  {
    options = OpenMesh::IO::Options::Binary | OpenMesh::IO::Options::LSB;
  }
  stream.imbue(std::locale::classic());
  FlatExporter exporter(points, triangles);
  // Nine digits bring back every float.
  const bool done = OpenMesh::IO::IOManager().write(stream, extension, exporter, options, 9);
  return done && stream.good();
}
