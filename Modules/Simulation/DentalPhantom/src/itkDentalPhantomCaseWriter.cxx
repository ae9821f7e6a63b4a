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
#include "itkDentalPhantomCaseWriter.h"

#include "itkDentalContourFileWriter.h"
#include "itkDentalInputError.h"
#include "itkDentalLandmarkFileWriter.h"
#include "itkJsonNumber.h"
#include "itkOpenMeshMeshIO.h"
#include "itkTextFile.h"

#include "itkImageFileWriter.h"
#include "itkMeshFileWriter.h"
#include "itkPNGImageIO.h"

#include <filesystem>
#include <sstream>

namespace itk
{
namespace
{
/** Removes a folder of unfinished files unless it was moved away. */
class TemporaryDirectory
{
public:
  explicit TemporaryDirectory(const std::string & target)
  {
    // Beside the target, so that moving it is a rename.
    for (unsigned int attempt = 0; attempt < 1000; ++attempt)
    {
      m_Path = target + ".part" + std::to_string(attempt);
      std::error_code error;
      if (std::filesystem::create_directory(m_Path, error))
      {
        return;
      }
      if (error)
      {
        itkDentalInputErrorMacro(target,
                                 "",
                                 "cannot be created: " + error.message(),
                                 "name a folder whose parent exists and may be written to");
      }
    }
    itkDentalInputErrorMacro(target, "", "too many unfinished folders beside it", "remove " + target + ".part*");
  }
  ~TemporaryDirectory()
  {
    std::error_code ignored;
    std::filesystem::remove_all(m_Path, ignored);
  }
  TemporaryDirectory(const TemporaryDirectory &) = delete;
  TemporaryDirectory &
  operator=(const TemporaryDirectory &) = delete;

  const std::string &
  GetPath() const
  {
    return m_Path;
  }

private:
  std::string m_Path;
};

std::string
Pair(const std::string & first, const std::string & second)
{
  return "[" + first + ", " + second + "]";
}

void
WriteMesh(DentalPhantomCaseSource::MeshType * mesh, const std::string & fileName)
{
  using WriterType = MeshFileWriter<DentalPhantomCaseSource::MeshType>;
  auto writer = WriterType::New();
  writer->SetMeshIO(OpenMeshMeshIO::New());
  writer->SetFileName(fileName);
  writer->SetInput(mesh);
  writer->SetFileTypeAsBINARY();
  writer->Update();
}

template <unsigned int VDimension>
void
WriteLandmarks(const DentalLandmarkSet<VDimension> * upper,
               const DentalLandmarkSet<VDimension> * lower,
               const std::string &                   fileName)
{
  auto all = DentalLandmarkSet<VDimension>::New();
  for (const auto * set : { upper, lower })
  {
    for (const auto & landmark : set->GetLandmarks())
    {
      all->AddLandmark(landmark.name, landmark.point);
    }
  }
  auto writer = DentalLandmarkFileWriter<VDimension>::New();
  writer->SetInput(all);
  writer->SetFileName(fileName);
  writer->Write();
}

std::string
MatrixText(const CephalometricGeometry::ProjectionMatrixType & matrix)
{
  std::string text = "[";
  for (unsigned int row = 0; row < 3; ++row)
  {
    text += row == 0 ? "[" : ", [";
    for (unsigned int column = 0; column < 4; ++column)
    {
      text += (column == 0 ? "" : ", ") + JsonNumber(matrix(row, column));
    }
    text += "]";
  }
  return text + "]";
}

std::string
Name(CephalometricGeometry::SourceSideEnum side)
{
  return side == CephalometricGeometry::SourceSideEnum::Right ? "right" : "left";
}
} // namespace

void
DentalPhantomCaseWriter::Write()
{
  if (!m_CaseSource)
  {
    itkExceptionMacro("No case to write: call SetCaseSource().");
  }
  if (m_DirectoryName.empty())
  {
    itkExceptionMacro("No folder to write to: call SetDirectoryName().");
  }
  if (m_MeshExtension != "stl" && m_MeshExtension != "ply" && m_MeshExtension != "obj" && m_MeshExtension != "off")
  {
    itkExceptionMacro("The mesh extension is \"" << m_MeshExtension << "\": use stl, ply, obj or off.");
  }
  std::string target = m_DirectoryName;
  while (target.size() > 1 && target.back() == '/')
  {
    target.pop_back();
  }
  m_CaseSource->Update();

  const TemporaryDirectory temporary(target);
  this->WriteFiles(temporary.GetPath());

  std::error_code error;
  if (!std::filesystem::exists(target))
  {
    std::filesystem::rename(temporary.GetPath(), target, error);
  }
  else
  {
    std::filesystem::path last;
    for (const auto & entry : std::filesystem::directory_iterator(temporary.GetPath()))
    {
      if (entry.path().filename() == "case.json")
      {
        last = entry.path();
      }
      else if (!error)
      {
        std::filesystem::rename(entry.path(), std::filesystem::path(target) / entry.path().filename(), error);
      }
    }
    if (!error)
    {
      std::filesystem::rename(last, std::filesystem::path(target) / last.filename(), error);
    }
  }
  if (error)
  {
    itkDentalInputErrorMacro(
      target, "", "cannot be written: " + error.message(), "name a folder that may be written to");
  }
}

void
DentalPhantomCaseWriter::WriteFiles(const std::string & directory)
{
  DentalPhantomCaseSource & source = *m_CaseSource;
  const auto &              nominal = *source.GetNominalGeometry();
  const std::string         base = directory + "/";
  WriteMesh(source.GetMesh(0), base + "upper." + m_MeshExtension);
  WriteMesh(source.GetMesh(1), base + "lower." + m_MeshExtension);

  auto contours = DentalContourFileWriter::New();
  contours->SetUpper(source.GetTracing(0));
  contours->SetLower(source.GetTracing(1));
  contours->SetImageSize(source.GetImageSize());
  contours->SetFileName(base + "contours.json");
  contours->Write();
  WriteLandmarks<3>(source.GetLandmarks3D(0), source.GetLandmarks3D(1), base + "landmarks3d.json");
  WriteLandmarks<2>(source.GetLandmarks2D(0), source.GetLandmarks2D(1), base + "landmarks2d.json");

  if (source.GetMakeRadiograph())
  {
    auto image = ImageFileWriter<DentalPhantomCaseSource::ImageType>::New();
    image->SetImageIO(PNGImageIO::New());
    image->SetFileName(base + "ceph.png");
    image->SetInput(source.GetRadiograph());
    image->UseCompressionOn();
    image->Update();
  }

  const auto &       spacing = nominal.GetPixelSpacing();
  const auto &       principal = nominal.GetPrincipalPoint();
  std::ostringstream side;
  side << source.GetTracedSide();
  std::ostringstream text;
  text << "{\n"
       << " \"upper\": \"upper." << m_MeshExtension << "\",\n"
       << " \"lower\": \"lower." << m_MeshExtension << "\",\n"
       << " \"mesh_unit\": \"mm\",\n"
       << " \"cephalogram\": {\n";
  if (source.GetMakeRadiograph())
  {
    text << "  \"image\": \"ceph.png\",\n";
  }
  text << "  \"pixel_spacing_mm\": " << Pair(JsonNumber(spacing[0]), JsonNumber(spacing[1])) << ",\n"
       << "  \"spacing_plane\": \"detector\",\n"
       << "  \"facing\": \"" << (nominal.GetFacingSign() > 0.0 ? "right" : "left") << "\"\n"
       << " },\n"
       << " \"geometry\": {\n"
       << "  \"source_to_midsagittal_mm\": " << JsonNumber(nominal.GetSourceToMidsagittalDistance()) << ",\n"
       << "  \"source_to_detector_mm\": " << JsonNumber(nominal.GetSourceToDetectorDistance()) << ",\n"
       << "  \"source_side\": \"" << Name(nominal.GetSourceSide()) << "\",\n"
       << "  \"principal_point_px\": " << Pair(JsonNumber(principal[0]), JsonNumber(principal[1])) << "\n"
       << " },\n"
       << " \"contours\": \"contours.json\",\n"
       << " \"traced_side\": \"" << side.str() << "\",\n"
       << " \"landmarks_3d\": \"landmarks3d.json\",\n"
       << " \"landmarks_2d\": \"landmarks2d.json\"\n"
       << "}\n";
  WriteFileAtomically(base + "case.json", text.str());

  const auto &       drawn = source.GetAcquisition();
  const auto &       exact = *source.GetTrueGeometry(0);
  std::ostringstream cohort;
  cohort << source.GetCohort();
  std::ostringstream truth;
  truth << "{\n"
        << " \"schema\": \"dentalscr-phantom-truth/1\",\n"
        << " \"seed\": " << source.GetSeed() << ",\n"
        << " \"cohort\": \"" << cohort.str() << "\",\n"
        << " \"buccal_outline\": " << (source.GetBuccalOutline() ? "true" : "false") << ",\n"
        << " \"yaw_rad\": " << JsonNumber(drawn.yaw) << ",\n"
        << " \"roll_rad\": " << JsonNumber(drawn.roll) << ",\n"
        << " \"pitch_rad\": " << JsonNumber(drawn.pitch) << ",\n"
        << " \"source_to_midsagittal_mm\": " << JsonNumber(exact.GetSourceToMidsagittalDistance()) << ",\n"
        << " \"source_to_detector_mm\": " << JsonNumber(exact.GetSourceToDetectorDistance()) << ",\n"
        << " \"noise_px\": {\"correlated\": " << JsonNumber(drawn.correlatedNoise)
        << ", \"white\": " << JsonNumber(drawn.whiteNoise)
        << ", \"correlation_length\": " << JsonNumber(drawn.correlationLength) << "},\n"
        << " \"projection_3x4\": {\n"
        << "  \"upper\": " << MatrixText(source.GetTrueGeometry(0)->GetProjectionMatrix()) << ",\n"
        << "  \"lower\": " << MatrixText(source.GetTrueGeometry(1)->GetProjectionMatrix()) << "\n"
        << " }\n"
        << "}\n";
  WriteFileAtomically(base + "truth.json", truth.str());
}

void
DentalPhantomCaseWriter::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  itkPrintSelfObjectMacro(CaseSource);
  os << indent << "DirectoryName: " << m_DirectoryName << std::endl;
  os << indent << "MeshExtension: " << m_MeshExtension << std::endl;
}
} // namespace itk
