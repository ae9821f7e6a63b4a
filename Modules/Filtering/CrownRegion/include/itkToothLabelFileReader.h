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
#ifndef itkToothLabelFileReader_h
#define itkToothLabelFileReader_h

#include "CrownRegionExport.h"
#include "itkToothCode.h"

#include "itkProcessObject.h"
#include "itkSimpleDataObjectDecorator.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace itk
{
/** \class ToothLabelFileReader
 * \brief Tooth labels of a mesh's points: JSON files of Teeth3DS and 3DTeethSeg22, VTK and PLY files of DCBIA's tools.
 *
 * JSON: `{"jaw": "upper", "labels": [0, 0, 11, 11, ...], ...}`: one number a point, in the order of the points of the
 * mesh's file; FDI, 0 for gingiva. With Numbering Universal the numbers are 1 to 32, and 0 or 33 for gingiva, as in the
 * array `Universal_ID` of DCBIA; a member of that name (or `UniversalID`, `PredictedID`) in place of `labels` is read
 * so whatever Numbering says.
 *
 * .vtk, .vtp (PolyData) and .ply: the point array, in PLY the vertices' property, of one of these names, always
 * universal numbers; it is in the order of the file's own points.
 *
 * SetNumberOfPoints() has the count checked. OBJ, PLY and OFF are read with their points as in the file; points of STL
 * are welded and numbered anew, so that labels fit no mesh that was read from STL unless they were made for it.
 *
 * Throws a DentalInputError for a file that cannot be read, labels that are no permanent teeth, a jaw that contradicts
 * them, and a count that is not the mesh's.
 *
 * \ingroup CrownRegion
 */
class CrownRegion_EXPORT ToothLabelFileReader : public ProcessObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ToothLabelFileReader);

  using Self = ToothLabelFileReader;
  using Superclass = ProcessObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(ToothLabelFileReader, ProcessObject);

  using NumberingEnum = ToothCode::NumberingEnum;
  using JawEnum = ToothCode::JawEnum;
  using LabelContainerType = std::vector<std::uint8_t>;
  using LabelObjectType = SimpleDataObjectDecorator<LabelContainerType>;
  /** The file to read. Must be set. */
  itkSetStringMacro(FileName);
  itkGetStringMacro(FileName);

  /** FDI (default) or Universal. */
  itkSetEnumMacro(Numbering, NumberingEnum);
  itkGetEnumMacro(Numbering, NumberingEnum);

  /** Of the mesh that is labelled; 0 (default) checks nothing. */
  itkSetMacro(NumberOfPoints, SizeValueType);
  itkGetConstMacro(NumberOfPoints, SizeValueType);
  /** FDI numbers, one a point of the mesh, 0 where there is no tooth. */
  LabelObjectType *
  GetOutput();
  const LabelObjectType *
  GetOutput() const;

  /** FDI by point, 0 for gingiva. Valid after Update(). */
  const LabelContainerType &
  GetLabels() const
  {
    return this->GetOutput()->Get();
  }

  /** As the file says, else as its labels do; Unknown where neither does. Valid after Update(). */
  itkGetEnumMacro(Jaw, JawEnum);

  /** Makes the labels the mesh's point data. Throws where the numbers of points differ. */
  template <typename TMesh>
  void
  LabelMesh(TMesh * mesh) const;

  using Superclass::MakeOutput;
  DataObjectPointer
  MakeOutput(DataObjectPointerArraySizeType index) override;

protected:
  ToothLabelFileReader();
  ~ToothLabelFileReader() override = default;

  void
  VerifyPreconditions() ITKv5_CONST override;

  void
  GenerateData() override;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  void
  ReadJson();
  void
  ReadSurface();

  /** Numbers of the file to FDI. `fail(index, problem, remedy)` throws. */
  template <typename TFail>
  void
  TakeLabels(const std::vector<double> & values, NumberingEnum numbering, const TFail & fail);

  void
  CheckCount(std::size_t labels, std::size_t points, const std::string & field) const;

  std::string   m_FileName;
  NumberingEnum m_Numbering{ NumberingEnum::FDI };
  SizeValueType m_NumberOfPoints{ 0 };
  JawEnum       m_Jaw{ JawEnum::Unknown };
  /** Points labelled as upper and as lower teeth. */
  std::array<std::size_t, 2> m_NumbersOfJaw{ { 0, 0 } };
};

template <typename TMesh>
void
ToothLabelFileReader::LabelMesh(TMesh * mesh) const
{
  const LabelContainerType & labels = this->GetLabels();
  this->CheckCount(labels.size(), mesh->GetNumberOfPoints(), "labels");
  auto data = TMesh::PointDataContainer::New();
  if (!labels.empty())
  {
    auto label = labels.begin();
    for (auto it = mesh->GetPoints()->Begin(); it != mesh->GetPoints()->End(); ++it, ++label)
    {
      data->InsertElement(it.Index(), static_cast<typename TMesh::PixelType>(*label));
    }
  }
  mesh->SetPointData(data);
}
} // namespace itk

#endif
