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
#include "itkToothLabelFileReader.h"

#include "itkDentalInputError.h"
#include "itkJsonDocument.h"
#include "itkSurfaceMeshFile.h"
#include "itkVTKSurfaceFile.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace itk
{
ToothLabelFileReader::ToothLabelFileReader()
{
  this->SetNumberOfRequiredOutputs(1);
  this->SetNthOutput(0, LabelObjectType::New());
}

DataObject::Pointer
ToothLabelFileReader::MakeOutput(DataObjectPointerArraySizeType)
{
  return LabelObjectType::New().GetPointer();
}

auto
ToothLabelFileReader::GetOutput() -> LabelObjectType *
{
  return static_cast<LabelObjectType *>(this->GetPrimaryOutput());
}

auto
ToothLabelFileReader::GetOutput() const -> const LabelObjectType *
{
  return static_cast<const LabelObjectType *>(this->GetPrimaryOutput());
}

void
ToothLabelFileReader::VerifyPreconditions() ITKv5_CONST
{
  Superclass::VerifyPreconditions();
  if (m_FileName.empty())
  {
    itkExceptionMacro("No file to read. Call SetFileName() first.");
  }
  if (m_Numbering == NumberingEnum::Quadrant)
  {
    itkExceptionMacro("Numbering is Quadrant, but labels of points are numbers. Call SetNumbering() with FDI or "
                      "Universal.");
  }
}

void
ToothLabelFileReader::CheckCount(std::size_t labels, std::size_t points, const std::string & field) const
{
  if (labels != points)
  {
    itkDentalInputErrorMacro(m_FileName,
                             field,
                             "has " + std::to_string(labels) + " labels, the mesh " + std::to_string(points) +
                               " points",
                             "use the mesh file that was labelled, as OBJ, PLY or OFF; the points of an STL file are "
                             "welded and numbered anew");
  }
}

template <typename TFail>
void
ToothLabelFileReader::TakeLabels(const std::vector<double> & values, NumberingEnum numbering, const TFail & fail)
{
  const bool           universal = numbering == NumberingEnum::Universal;
  std::array<int, 256> known;
  known.fill(-1);
  known[0] = 0;
  if (universal)
  {
    known[33] = 0;
  }
  std::array<std::size_t, 2> ofJaw{ { 0, 0 } };
  LabelContainerType         labels(values.size(), 0);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const bool whole = values[i] >= 0.0 && values[i] < 256.0 && values[i] == std::floor(values[i]);
    const auto value = static_cast<std::size_t>(whole ? values[i] : 255.0);
    if (known[value] < 0)
    {
      try
      {
        known[value] = ToothCode::FromString(std::to_string(value), numbering).GetFDI();
      }
      catch (const std::invalid_argument &)
      {
        std::ostringstream problem;
        problem << "is " << values[i] << ", which is no tooth's " << (universal ? "universal" : "FDI") << " number";
        fail(i,
             problem.str(),
             universal ? "give 1 to 32, 0 or 33 for gingiva"
                       : "give 11 to 48 (primary 51 to 85), 0 for gingiva; or say that the numbering is universal");
      }
    }
    labels[i] = static_cast<std::uint8_t>(known[value]);
    if (labels[i] != 0)
    {
      ++ofJaw[ToothCode(labels[i]).GetJaw() == JawEnum::Upper ? 0 : 1];
    }
  }
  m_NumbersOfJaw = ofJaw;
  if (ofJaw[0] != ofJaw[1])
  {
    m_Jaw = ofJaw[0] > ofJaw[1] ? JawEnum::Upper : JawEnum::Lower;
  }
  this->GetOutput()->Set(labels);
}

void
ToothLabelFileReader::ReadSurface()
{
  std::string         name;
  std::vector<double> values;
  bool                ofCells = false;
  if (IsVTKSurfaceFileName(m_FileName))
  {
    VTKSurfaceFile surface = ReadVTKSurfaceFile(m_FileName);
    name = surface.labelName;
    values = std::move(surface.labels);
    ofCells = surface.labelsOfCells;
  }
  else
  {
    try
    {
      SurfaceMeshFile surface = ReadSurfaceMeshFile(m_FileName);
      name = surface.vertexLabelName;
      values = std::move(surface.vertexLabels);
    }
    catch (const SurfaceMeshFileError & error)
    {
      itkDentalInputErrorMacro(m_FileName, error.field, error.problem, error.remedy);
    }
  }
  if (name.empty())
  {
    itkDentalInputErrorMacro(m_FileName,
                             "",
                             ofCells ? "has tooth labels of its faces, not of its points"
                                     : "has no tooth labels: no point array Universal_ID, UniversalID or PredictedID",
                             ofCells ? "turn the cell data into point data" : "name the file that was labelled");
  }
  if (m_NumberOfPoints != 0)
  {
    this->CheckCount(values.size(), m_NumberOfPoints, name);
  }
  this->TakeLabels(
    values, NumberingEnum::Universal, [&](std::size_t i, const std::string & problem, const std::string & remedy) {
      itkDentalInputErrorMacro(m_FileName, name + "[" + std::to_string(i) + "]", problem, remedy);
    });
}

void
ToothLabelFileReader::ReadJson()
{
  const JsonDocument document = JsonDocument::ReadFile(m_FileName);
  const JsonNode     root = document.GetRoot();
  NumberingEnum      numbering = m_Numbering;
  std::string        field = "labels";
  if (!root.Find(field))
  {
    for (const char * name : { "Universal_ID", "UniversalID", "PredictedID" })
    {
      if (root.Find(name))
      {
        field = name;
        numbering = NumberingEnum::Universal;
        break;
      }
    }
  }
  const JsonNode    list = root.Get(field);
  const std::size_t count = list.GetSize();
  if (m_NumberOfPoints != 0)
  {
    this->CheckCount(count, m_NumberOfPoints, field);
  }
  if (count == 0)
  {
    list.Fail("is empty", "give one label a point of the mesh, 0 for gingiva");
  }
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    values[i] = static_cast<double>(list.At(i).AsInteger(0, 255));
  }
  this->TakeLabels(values, numbering, [&](std::size_t i, const std::string & problem, const std::string & remedy) {
    list.At(i).Fail(problem, remedy);
  });
  if (const auto jaw = root.Find("jaw"))
  {
    const std::string & name = jaw->AsString();
    if (name != "upper" && name != "lower")
    {
      jaw->Fail("is \"" + name + "\"", "give \"upper\" or \"lower\"");
    }
    m_Jaw = name == "upper" ? JawEnum::Upper : JawEnum::Lower;
    if (m_NumbersOfJaw[name == "upper" ? 1 : 0] > m_NumbersOfJaw[name == "upper" ? 0 : 1])
    {
      jaw->Fail("is \"" + name + "\", but most labels are teeth of the other jaw", "correct the jaw or the numbering");
    }
  }
}

void
ToothLabelFileReader::GenerateData()
{
  m_Jaw = JawEnum::Unknown;
  const MeshFileFormatEnum named = MeshFileFormatFromName(m_FileName);
  if (IsVTKSurfaceFileName(m_FileName) || named == MeshFileFormatEnum::PLY)
  {
    this->ReadSurface();
  }
  else if (named != MeshFileFormatEnum::Unknown)
  {
    itkDentalInputErrorMacro(
      m_FileName, "", "a file of this format has no tooth labels", "name a .json, .vtk, .vtp or .ply file");
  }
  else
  {
    this->ReadJson();
  }
}

void
ToothLabelFileReader::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << m_FileName << std::endl;
  os << indent << "Numbering: " << m_Numbering << std::endl;
  os << indent << "NumberOfPoints: " << m_NumberOfPoints << std::endl;
  os << indent << "Jaw: " << m_Jaw << std::endl;
  os << indent << "NumbersOfJaw: " << m_NumbersOfJaw[0] << " " << m_NumbersOfJaw[1] << std::endl;
}
} // namespace itk
