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
#include "itkDentalPhantomPicture.h"
#include "itkDentalPhantomTracer.h"
#include "itkJsonNumber.h"
#include "itkMakeTriangleSurface.h"
#include "itkOpenMeshMeshIO.h"
#include "itkOutputFolder.h"
#include "itkTextFile.h"
#include "itkWriteThroughMemory.h"

#include "itkImageFileWriter.h"
#include "itkMeshFileWriter.h"
#include "itkPNGImageIO.h"
#include "itkRGBPixel.h"

#include <algorithm>
#include <filesystem>
#include <sstream>

namespace itk
{
namespace
{
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
    if (set == nullptr)
    {
      continue;
    }
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
MatrixText(const PerspectiveProjection & projection)
{
  CephalometricGeometry::ProjectionMatrixType matrix;
  for (unsigned int row = 0; row < 3; ++row)
  {
    for (unsigned int column = 0; column < 4; ++column)
    {
      // Scaled so that the last row's numbers stay small.
      matrix(row, column) = projection.matrix[4 * row + column];
    }
  }
  return MatrixText(matrix);
}

std::string
PixelText(const std::array<double, 2> & p)
{
  return Pair(JsonNumber(p[0]), JsonNumber(p[1]));
}

/** Whole-tooth outlines, with what formats.md has for them beyond DentalContourFileWriter. */
void
WriteOutlines(const DentalPhantomCaseSource & source, const std::string & fileName)
{
  const auto &       tracing = *source.GetStandardTracing();
  const bool         confident = source.GetLevel().confidence != "none";
  std::ostringstream text;
  text << "{\n  \"image_size\": [" << source.GetImageSize()[0] << ", " << source.GetImageSize()[1]
       << "],\n  \"contours\": {";
  for (unsigned int jaw = 0; jaw < 2; ++jaw)
  {
    text << (jaw == 0 ? "\n    \"upper\": [" : ",\n    \"lower\": [");
    const char * separator = "\n";
    for (const auto & outline : tracing.GetOutlines(jaw))
    {
      text << separator << "      {\"code\": " << JsonString(ToothCode(outline.fdi).GetName())
           << ", \"closed\": true, \"outline\": \"tooth\"";
      if (confident)
      {
        text << ", \"sigma_px\": " << JsonNumber(outline.slip.statedSigma);
      }
      text << ", \"points\": [";
      for (std::size_t i = 0; i < outline.drawn.size(); ++i)
      {
        text << (i == 0 ? "" : ", ") << PixelText(outline.drawn[i]);
      }
      text << "]}";
      separator = ",\n";
    }
    text << "\n    ]";
  }
  text << "\n  }\n}\n";
  WriteFileAtomically(fileName, text.str());
}

/** Landmarks to register with, in the form that the level names. */
void
WriteCephalometricLandmarks(const DentalPhantomCaseSource & source, const std::string & fileName)
{
  const std::string & form = source.GetLevel().landmarkForm;
  std::string         text = form == "detector" ? "{\"landmarks\": [" : "{";
  const char *        separator = "\n";
  for (const auto & landmark : source.GetStandardTracing()->GetLandmarks())
  {
    text += separator;
    if (form == "detector")
    {
      // A detector's words follow its peak.
      const double peak = landmark.slip.GetPeak();
      text += "  {\"name\": " + JsonString(landmark.name) + ", \"x\": " + JsonNumber(landmark.drawn[0]) +
              ", \"y\": " + JsonNumber(landmark.drawn[1]) + ", \"peak\": " + JsonNumber(peak) + ", \"confidence\": " +
              (peak > 0.7    ? "\"high\""
               : peak > 0.45 ? "\"medium\""
                             : "\"low\"") +
              "}";
    }
    else if (form == "sigma")
    {
      text += "  " + JsonString(landmark.name) + ": {\"position\": " + PixelText(landmark.drawn) +
              ", \"sigma_px\": " + JsonNumber(landmark.slip.statedSigma) + "}";
    }
    else
    {
      text += "  " + JsonString(landmark.name) + ": " + PixelText(landmark.drawn);
    }
    separator = ",\n";
  }
  WriteFileAtomically(fileName, text + (form == "detector" ? "\n]}\n" : "\n}\n"));
}

/** What the dentition and its scans have, for a case of a level that has traits at all. */
std::string
TraitText(const DentalPhantomCaseSource & source)
{
  if (source.GetTraits().empty())
  {
    return {};
  }
  std::string  text = " \"traits\": [";
  const char * separator = "\n";
  for (const DentalPhantomTrait & trait : source.GetTraits())
  {
    text += std::string(separator) + "  {\"name\": " + JsonString(trait.name) + ", \"teeth\": [";
    for (std::size_t i = 0; i < trait.teeth.size(); ++i)
    {
      text += (i == 0 ? "" : ", ") + std::to_string(trait.teeth[i]);
    }
    text += "], \"amount\": " + JsonNumber(trait.amount) + "}";
    separator = ",\n";
  }
  return text + "\n ],\n";
}

/** What a source was told beside its level, where it is not what a new source has: with seed, level and these a case
 * can be made again. Facing, the source's side, the size of the picture and the traced side stand in the case itself.
 */
std::string
SettingsText(const DentalPhantomCaseSource & source)
{
  const auto  plain = DentalPhantomCaseSource::New();
  std::string text;
  const auto  add = [&text](const char * name, const std::string & value) {
    text += std::string(text.empty() ? "" : ", ") + JsonString(name) + ": " + value;
  };
  const auto addNumber = [&](const char * name, double value, double otherwise) {
    if (value != otherwise)
    {
      add(name, JsonNumber(value));
    }
  };
  addNumber("tooth_bias", source.GetToothBias(), plain->GetToothBias());
  addNumber("drop_out_fraction", source.GetDropOutFraction(), plain->GetDropOutFraction());
  addNumber("additional_yaw_rad", source.GetAdditionalYaw(), plain->GetAdditionalYaw());
  addNumber("additional_roll_rad", source.GetAdditionalRoll(), plain->GetAdditionalRoll());
  addNumber("upper_number_of_points", source.GetUpperNumberOfPoints(), plain->GetUpperNumberOfPoints());
  addNumber("lower_number_of_points", source.GetLowerNumberOfPoints(), plain->GetLowerNumberOfPoints());
  if (source.GetStoneBase() != plain->GetStoneBase())
  {
    add("stone_base", source.GetStoneBase() ? "true" : "false");
  }
  if (!source.GetMissingTeeth().empty())
  {
    std::string teeth;
    for (const unsigned int tooth : source.GetMissingTeeth())
    {
      teeth += (teeth.empty() ? "" : ", ") + std::to_string(tooth);
    }
    add("missing_teeth", "[" + teeth + "]");
  }
  return text.empty() ? text : ",\n \"settings\": {" + text + "}";
}

/** The drawings before their errors, the frontal view's answer and the parameters, where the level is none of the first
 * three, whose truth.json stays what it was. */
std::string
DrawingText(const DentalPhantomCaseSource & source)
{
  std::string text;
  if (const auto * tracing = source.GetStandardTracing())
  {
    text += ",\n \"outlines\": {";
    const char * separator = "\n";
    for (unsigned int jaw = 0; jaw < 2; ++jaw)
    {
      for (const auto & outline : tracing->GetOutlines(jaw))
      {
        text += std::string(separator) + "  " + JsonString(ToothCode(outline.fdi).GetName()) +
                ": {\"template\": " + (outline.isTemplate ? "true" : "false") +
                ", \"gross\": " + (outline.slip.gross ? "true" : "false") +
                ", \"shift_px\": " + PixelText(outline.slip.shift) +
                ", \"turn_rad\": " + JsonNumber(outline.slip.turn) + ", \"scale\": " + JsonNumber(outline.slip.scale) +
                ", \"sigma_px\": " + JsonNumber(outline.slip.sigma) + ", \"exact\": [";
        for (std::size_t i = 0; i < outline.exact.size(); ++i)
        {
          text += (i == 0 ? "" : ", ") + PixelText(outline.exact[i]);
        }
        text += "]}";
        separator = ",\n";
      }
    }
    text += "\n },\n \"cephalometric_landmarks\": {";
    separator = "\n";
    for (const auto & landmark : tracing->GetLandmarks())
    {
      text += std::string(separator) + "  " + JsonString(landmark.name) + ": {\"exact\": " + PixelText(landmark.exact) +
              ", \"gross\": " + (landmark.slip.gross ? "true" : "false") +
              ", \"sigma_px\": " + JsonNumber(landmark.slip.sigma) + "}";
      separator = ",\n";
    }
    text += "\n }";
  }
  if (const auto * frontal = source.GetFrontalView())
  {
    text += ",\n \"views\": {\"frontal\": {\"projection_3x4\": {\n  \"upper\": " + MatrixText(frontal->projections[0]) +
            ",\n  \"lower\": " + MatrixText(frontal->projections[1]) + "\n },\n \"landmarks_px\": {";
    const char * separator = "\n";
    for (const auto & landmark : frontal->trueLandmarks->GetLandmarks())
    {
      text += std::string(separator) + "  " + JsonString(landmark.name) + ": " +
              PixelText({ { landmark.point[0], landmark.point[1] } });
      separator = ",\n";
    }
    // A hand of its own: the lateral tracing's correlation length is drawn, this one's is the tracer's.
    const DentalPhantomLevel & level = source.GetLevel();
    text += "\n },\n \"noise_px\": {\"correlated\": " + JsonNumber(level.correlatedNoise) +
            ", \"white\": " + JsonNumber(level.whiteNoise) +
            ", \"correlation_length\": " + JsonNumber(DentalPhantomTracer::Noise().correlationLength) + "}}}";
  }
  // Side, frame and resolution stand in the case itself; what else differs from the first three tables is told.
  DentalPhantomLevel level = source.GetLevel();
  const auto         table = DentalPhantomLevel::Named(level.name);
  level.tracedSide = table.tracedSide;
  level.frame = table.frame;
  level.numberOfTriangles = table.numberOfTriangles;
  if ((level.name != "ideal" && level.name != "typical" && level.name != "hard") || level != table)
  {
    std::string parameters = source.GetLevel().ToJson();
    parameters.pop_back();
    text += ",\n \"parameters\": " + parameters;
  }
  return text;
}

/** Of a name of its own: itk::WriteImage() takes smart pointers, and whatever format is registered. */
template <typename TImage>
void
WritePNG(TImage * picture, const std::string & fileName)
{
  auto writer = ImageFileWriter<TImage>::New();
  writer->SetImageIO(PNGImageIO::New());
  writer->SetInput(picture);
  writer->UseCompressionOn();
  WriteThroughMemory(writer.GetPointer(), fileName);
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

  const std::filesystem::path parent = std::filesystem::absolute(target).parent_path();
  if (!std::filesystem::is_directory(parent))
  {
    itkDentalInputErrorMacro(target,
                             "",
                             "cannot be created: its parent is no folder",
                             "name a folder whose parent exists and may be written to");
  }
  OutputFolder folder(target);
  this->WriteFiles(folder.GetStagingFolder());
  folder.Publish("case.json");
}

void
DentalPhantomCaseWriter::WriteFiles(const std::string & directory)
{
  DentalPhantomCaseSource & source = *m_CaseSource;
  const auto &              nominal = *source.GetNominalGeometry();
  const std::string         base = directory + "/";
  WriteMesh(source.GetMesh(0), base + "upper." + m_MeshExtension);
  WriteMesh(source.GetMesh(1), base + "lower." + m_MeshExtension);

  const bool        standard = source.GetTracedSide() == DentalPhantomCaseSource::TracedSideEnum::Standard;
  const bool        hasContours = source.GetLevel().drawOutlines || !standard;
  const bool        hasLandmarks = source.GetStandardTracing() != nullptr && source.GetLevel().giveLandmarks;
  const std::string contoursName = standard ? "outlines.json" : "contours.json";
  const auto        writeContours = [&](DentalContour * upper, DentalContour * lower, const std::string & fileName) {
    auto contours = DentalContourFileWriter::New();
    contours->SetUpper(upper);
    contours->SetLower(lower);
    contours->SetImageSize(source.GetImageSize());
    contours->SetFileName(fileName);
    contours->Write();
  };
  if (standard && hasContours)
  {
    WriteOutlines(source, base + contoursName);
  }
  else if (hasContours)
  {
    writeContours(source.GetTracing(0), source.GetTracing(1), base + contoursName);
  }
  if (hasLandmarks)
  {
    WriteCephalometricLandmarks(source, base + "cephalometric.json");
  }
  const auto * frontal = source.GetFrontalView();
  if (frontal != nullptr)
  {
    writeContours(frontal->tracings[0], frontal->tracings[1], base + "frontal-contours.json");
    WriteLandmarks<2>(frontal->landmarks, nullptr, base + "frontal.json");
    if (frontal->image)
    {
      WritePNG(frontal->image.GetPointer(), base + "frontal.png");
    }
  }
  WriteLandmarks<3>(source.GetLandmarks3D(0), source.GetLandmarks3D(1), base + "landmarks3d.json");
  WriteLandmarks<2>(source.GetLandmarks2D(0), source.GetLandmarks2D(1), base + "landmarks2d.json");

  if (source.GetMakeRadiograph())
  {
    WritePNG(source.GetRadiograph(), base + "ceph.png");
  }

  const auto &       spacing = nominal.GetPixelSpacing();
  const auto &       principal = nominal.GetPrincipalPoint();
  std::ostringstream side;
  side << source.GetTracedSide();
  const auto writeCase = [&](const std::string & fileName, bool withContours, bool withLandmarks) {
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
    else if (!withContours)
    {
      // Without a picture and a tracing nothing else says how large the picture is.
      text << "  \"image_size\": [" << source.GetImageSize()[0] << ", " << source.GetImageSize()[1] << "],\n";
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
         << " },\n";
    if (withContours)
    {
      text << " \"contours\": " << JsonString(contoursName) << ",\n"
           << " \"traced_side\": \"" << side.str() << "\",\n";
    }
    if (withLandmarks)
    {
      text << " \"cephalometric_landmarks\": \"cephalometric.json\",\n";
    }
    if (frontal != nullptr)
    {
      text << " \"views\": [\n  {\n   \"name\": \"frontal\",\n   \"direction\": \"frontal\",\n   \"cephalogram\": {\n";
      if (frontal->image)
      {
        text << "    \"image\": \"frontal.png\",\n";
      }
      text << "    \"image_size\": [" << source.GetImageSize()[0] << ", " << source.GetImageSize()[1] << "],\n"
           << "    \"pixel_spacing_mm\": " << Pair(JsonNumber(frontal->spacing[0]), JsonNumber(frontal->spacing[1]))
           << ",\n    \"patient_left\": \"right\"\n   },\n   \"geometry\": {\n"
           << "    \"source_to_midcoronal_mm\": " << JsonNumber(frontal->sourceToMidcoronal) << ",\n"
           << "    \"source_to_detector_mm\": " << JsonNumber(frontal->sourceToDetector) << ",\n"
           << "    \"principal_point_px\": "
           << Pair(JsonNumber(frontal->principalPoint[0]), JsonNumber(frontal->principalPoint[1])) << "\n   },\n"
           << "   \"contours\": \"frontal-contours.json\",\n   \"cephalometric_landmarks\": \"frontal.json\",\n"
           << "   \"same_head_position\": " << (frontal->sameHeadPosition ? "true" : "false") << "\n  }\n ],\n";
    }
    text << " \"landmarks_3d\": \"landmarks3d.json\",\n"
         << " \"landmarks_2d\": \"landmarks2d.json\"\n"
         << "}\n";
    WriteFileAtomically(base + fileName, text.str());
  };
  if (hasContours && hasLandmarks)
  {
    // The same patient by either alone.
    writeCase("case-outlines.json", true, false);
    writeCase("case-landmarks.json", false, true);
  }
  writeCase("case.json", hasContours, hasLandmarks);

  if (m_PreviewSize > 0)
  {
    std::array<TriangleSurface, 2>           surfaces;
    std::array<std::vector<std::uint8_t>, 2> labels;
    for (unsigned int jaw = 0; jaw < 2; ++jaw)
    {
      const auto * mesh = source.GetMesh(jaw);
      surfaces[jaw] = MakeTriangleSurface(mesh);
      for (auto it = mesh->GetPointData()->Begin(); it != mesh->GetPointData()->End(); ++it)
      {
        labels[jaw].push_back(static_cast<std::uint8_t>(it.Value()));
      }
    }
    const auto bytes = DentalPhantomPicture::Render(surfaces, labels, source.GetParameters(), m_PreviewSize);
    using ColourImageType = Image<RGBPixel<unsigned char>, 2>;
    auto picture = ColourImageType::New();
    picture->SetRegions(ColourImageType::SizeType{ { 4u * m_PreviewSize, m_PreviewSize } });
    picture->Allocate();
    std::copy(bytes.begin(), bytes.end(), reinterpret_cast<unsigned char *>(picture->GetBufferPointer()));
    WritePNG(picture.GetPointer(), base + "preview.png");
  }

  const auto &       drawn = source.GetAcquisition();
  const auto &       exact = *source.GetTrueGeometry(0);
  std::ostringstream cohort;
  cohort << source.GetLevel().name;
  std::ostringstream truth;
  truth << "{\n"
        << " \"schema\": \"dentalscr-phantom-truth/1\",\n"
        << " \"seed\": " << source.GetSeed() << ",\n"
        << " \"cohort\": \"" << cohort.str() << "\",\n"
        << " \"buccal_outline\": " << (source.GetBuccalOutline() ? "true" : "false") << ",\n"
        << TraitText(source) << " \"yaw_rad\": " << JsonNumber(drawn.yaw) << ",\n"
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
        << " }" << SettingsText(source) << DrawingText(source) << "\n"
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
  os << indent << "PreviewSize: " << m_PreviewSize << std::endl;
}
} // namespace itk
