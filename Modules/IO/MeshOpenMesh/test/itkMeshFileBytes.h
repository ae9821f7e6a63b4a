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
#ifndef itkMeshFileBytes_h
#define itkMeshFileBytes_h

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

/** Mesh files made byte by byte, so that the readers are tested against the formats and not against our writer. */
namespace mesh_file_bytes
{
using Facet = std::array<std::array<float, 3>, 3>;

template <typename T>
void
Append(std::string & bytes, T value, bool bigEndian = false)
{
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  for (std::size_t i = 0; i < sizeof(T); ++i)
  {
    bytes += raw[bigEndian ? sizeof(T) - 1 - i : i];
  }
}

inline std::string
BinarySTL(const std::vector<Facet> & facets, std::string header = "made by a test")
{
  header.resize(80, ' ');
  Append(header, static_cast<std::uint32_t>(facets.size()));
  for (const Facet & facet : facets)
  {
    header.append(12, '\0');
    for (const auto & corner : facet)
    {
      for (const float coordinate : corner)
      {
        Append(header, coordinate);
      }
    }
    header.append(2, '\0');
  }
  return header;
}

/** A tetrahedron: 4 points, 4 facets. */
inline std::vector<Facet>
TetrahedronFacets()
{
  const std::array<float, 3> o{ 0, 0, 0 };
  const std::array<float, 3> x{ 1.5f, 0, 0 };
  const std::array<float, 3> y{ 0, 2.25f, 0 };
  const std::array<float, 3> z{ 0, 0, 3.125f };
  return { Facet{ o, y, x }, Facet{ o, x, z }, Facet{ o, z, y }, Facet{ x, y, z } };
}

inline std::string
TetrahedronAsciiSTL()
{
  std::string text = "solid tetrahedron\n";
  for (const Facet & facet : TetrahedronFacets())
  {
    text += " facet normal 0 0 0\n  outer loop\n";
    for (const auto & corner : facet)
    {
      text += "   vertex";
      for (const float coordinate : corner)
      {
        // Exact: all are multiples of 1/8.
        text += ' ' + std::to_string(static_cast<double>(coordinate));
      }
      text += '\n';
    }
    text += "  endloop\n endfacet\n";
  }
  return text + "endsolid tetrahedron\n";
}

constexpr const char * TetrahedronPoints = "0 0 0\n1.5 0 0\n0 2.25 0\n0 0 3.125\n";
constexpr const char * TetrahedronFaces = "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

inline std::string
TetrahedronOFF()
{
  return std::string("OFF\n4 4 6\n") + TetrahedronPoints + TetrahedronFaces;
}

inline std::string
TetrahedronOBJ()
{
  return "# comment\nmtllib a.mtl\no tooth\nv 0 0 0\nv 1.5 0 0\nv 0 2.25 0\nv 0 0 3.125\nvt 0 0\nvn 0 0 1\ng a b\n"
         "usemtl red\ns off\nf 1 3 2\nf 1/1 2/1 4/1\nf 1//1 4//1 3//1\nf -3/-1/-1 -2/-1/-1 -1/-1/-1\n";
}

inline std::string
TetrahedronPLY()
{
  return std::string("ply\nformat ascii 1.0\ncomment made by a test\nelement vertex 4\nproperty float x\n"
                     "property float y\nproperty float z\nelement face 4\nproperty list uchar int vertex_indices\n"
                     "end_header\n") +
         TetrahedronPoints + TetrahedronFaces;
}

/** Awkward on purpose: further properties, a list in the vertices, double beside float, elements in between. */
inline std::string
TetrahedronBinaryPLY(bool bigEndian)
{
  std::string bytes = std::string("ply\nformat binary_") + (bigEndian ? "big" : "little") +
                      "_endian 1.0\nobj_info a b\nelement camera 1\nproperty float view\nproperty list uchar int q\n"
                      "element vertex 4\nproperty double z\nproperty uchar red\nproperty float x\n"
                      "property list ushort short near\nproperty float y\nelement face 4\nproperty uchar flag\n"
                      "property list uint uint vertex_index\nproperty list uchar float texcoord\nend_header\n";
  Append(bytes, 1.0f, bigEndian);
  bytes += '\2';
  Append(bytes, 7, bigEndian);
  Append(bytes, 8, bigEndian);
  const float points[4][3] = { { 0, 0, 0 }, { 1.5f, 0, 0 }, { 0, 2.25f, 0 }, { 0, 0, 3.125f } };
  for (const auto & point : points)
  {
    Append(bytes, static_cast<double>(point[2]), bigEndian);
    bytes += '\x7f';
    Append(bytes, point[0], bigEndian);
    Append(bytes, std::uint16_t{ 1 }, bigEndian);
    Append(bytes, std::int16_t{ -5 }, bigEndian);
    Append(bytes, point[1], bigEndian);
  }
  const std::uint32_t faces[4][3] = { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 } };
  for (const auto & face : faces)
  {
    bytes += '\1';
    Append(bytes, std::uint32_t{ 3 }, bigEndian);
    for (const std::uint32_t corner : face)
    {
      Append(bytes, corner, bigEndian);
    }
    bytes += '\1';
    Append(bytes, 0.5f, bigEndian);
  }
  return bytes;
}
} // namespace mesh_file_bytes

#endif
