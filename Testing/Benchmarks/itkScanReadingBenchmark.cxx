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
#include "itkBenchmark.h"

#include "itkBinarySTLKernel.h"

#include "vtkCleanPolyData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"
#include "vtkSTLReader.h"

#include <filesystem>
#include <map>
#include <sstream>
#include <string>

namespace itk
{
namespace
{
std::string
MakeFile(const TriangleSurface & surface)
{
  static std::map<const TriangleSurface *, std::string> files;
  std::string &                                         name = files[&surface];
  if (name.empty())
  {
    name = BenchmarkFolder() + "/scan" + std::to_string(files.size()) + ".stl";
    WriteBinarySTL(name, surface);
  }
  return name;
}

/** Reads, welds, computes normals and areas; returns the number of points. */
std::size_t
Read(const std::string & name)
{
  const WeldedTriangles mesh = ReadBinarySTL(name.c_str());
  const auto            normals = ComputeNormalsAndAreas(mesh.points, mesh.triangles);
  benchmark::DoNotOptimize(normals.data());
  return mesh.points.size();
}

std::size_t
ReadByVTK(const std::string & name)
{
  vtkNew<vtkSTLReader> reader;
  reader->SetFileName(name.c_str());
  reader->MergingOff();
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputConnection(reader->GetOutputPort());
  clean->ToleranceIsAbsoluteOn();
  clean->SetAbsoluteTolerance(0.0);
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputConnection(clean->GetOutputPort());
  normals->SplittingOff();
  normals->ConsistencyOff();
  normals->Update();
  return static_cast<std::size_t>(normals->GetOutput()->GetNumberOfPoints());
}

/** Makes a surface once, when it is needed. */
using SurfaceFunction = const TriangleSurface & (*)();

BenchmarkFunction
Run(SurfaceFunction surface, std::size_t (*read)(const std::string &))
{
  return [surface, read](benchmark::State & state) {
    const std::string name = MakeFile(surface());
    std::size_t       points = 0;
    for (auto _ : state)
    {
      points = read(name);
    }
    state.counters["points"] = static_cast<double>(points);
  };
}

void
RegisterScan(const std::string & work, SurfaceFunction surface)
{
  const std::string kernel = "scan reading";
  RegisterKernel(kernel, work, Run(surface, Read));
  RegisterPeer(kernel, work, "vtkSTLReader + vtkCleanPolyData + vtkPolyDataNormals", 7.0, Run(surface, ReadByVTK));
  RegisterAtMost(kernel, work, "vertices that differ from VTK", 0.0, [surface](benchmark::State & state) {
    const std::string name = MakeFile(surface());
    for (auto _ : state)
    {
      const auto ours = static_cast<double>(Read(name));
      const auto theirs = static_cast<double>(ReadByVTK(name));
      state.counters["figure"] = ours > theirs ? ours - theirs : theirs - ours;
    }
  });
  RegisterAtMost(kernel, work, "memory over file", 4.0, [surface](benchmark::State & state) {
    const std::string name = MakeFile(surface());
    for (auto _ : state)
    {
      const double peak = PeakMemory([&]() { Read(name); });
      state.counters["figure"] = peak / static_cast<double>(std::filesystem::file_size(name));
    }
  });
}

template <int VTriangles>
const TriangleSurface &
Phantom()
{
  return PhantomSurface(VTriangles);
}

void
RegisterAll()
{
  RegisterScan("phantom, 1 M triangles", Phantom<1000000>);
  if (!CastSurface().points.empty())
  {
    std::ostringstream name;
    name << "scan of a cast, " << (CastSurface().triangles.size() + 500) / 1000 << " k triangles";
    RegisterScan(name.str(), CastSurface);
  }
  RegisterGrowth("scan reading", "triangles", 10000, Run(Phantom<10000>, Read));
  RegisterGrowth("scan reading", "triangles", 100000, Run(Phantom<100000>, Read));
  RegisterGrowth("scan reading", "triangles", 1000000, Run(Phantom<1000000>, Read));
}

const BenchmarkFile file(RegisterAll);
} // namespace
} // namespace itk
