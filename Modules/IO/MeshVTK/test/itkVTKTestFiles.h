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
#ifndef itkVTKTestFiles_h
#define itkVTKTestFiles_h

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataWriter.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLPolyDataWriter.h>

#include <string>

/** Files as VTK itself writes them. */
namespace VTKTestFiles
{
struct Kind
{
  bool xml;
  /** Legacy: 42 or 51. XML: 0 ascii, 1 binary, 2 appended, 3 appended as base64 and compressed. */
  int  variant;
  bool ascii;
};

constexpr Kind Kinds[] = { { false, 42, true }, { false, 42, false }, { false, 51, true }, { false, 51, false },
                           { true, 0, true },   { true, 1, false },   { true, 2, false },  { true, 3, false } };

/** A square of four points, two triangles (or a quad, or a strip) and labels 8, 9, 33, 0. */
template <typename TLabels>
void
Fill(vtkPolyData * data, const char * faces, const char * name)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.5);
  points->InsertNextPoint(1.0, 0.0, 0.25);
  points->InsertNextPoint(1.0, 1.0, 0.0);
  points->InsertNextPoint(0.0, 1.0, -0.125);
  data->SetPoints(points);
  vtkNew<vtkCellArray> cells;
  const std::string    kind(faces);
  if (kind == "triangles")
  {
    cells->InsertNextCell({ 0, 1, 2 });
    cells->InsertNextCell({ 0, 2, 3 });
  }
  else if (kind == "quad")
  {
    cells->InsertNextCell({ 0, 1, 2, 3 });
  }
  else
  {
    cells->InsertNextCell({ 0, 1, 3, 2 });
  }
  if (kind == "strip")
  {
    data->SetStrips(cells);
  }
  else
  {
    data->SetPolys(cells);
  }
  if (name != nullptr)
  {
    vtkNew<TLabels> labels;
    labels->SetName(name);
    for (const int label : { 8, 9, 33, 0 })
    {
      labels->InsertNextValue(static_cast<typename TLabels::ValueType>(label));
    }
    data->GetPointData()->AddArray(labels);
  }
}

inline void
Write(vtkPolyData * data, const Kind & kind, const std::string & fileName)
{
  if (kind.xml)
  {
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetInputData(data);
    writer->SetFileName(fileName.c_str());
    writer->SetDataMode(kind.variant == 0   ? vtkXMLWriter::Ascii
                        : kind.variant == 1 ? vtkXMLWriter::Binary
                                            : vtkXMLWriter::Appended);
    writer->SetEncodeAppendedData(kind.variant == 3);
    if (kind.variant < 3)
    {
      writer->SetCompressorTypeToNone();
    }
    writer->Write();
  }
  else
  {
    vtkNew<vtkPolyDataWriter> writer;
    writer->SetInputData(data);
    writer->SetFileName(fileName.c_str());
    writer->SetFileVersion(kind.variant);
    if (kind.ascii)
    {
      writer->SetFileTypeToASCII();
    }
    else
    {
      writer->SetFileTypeToBinary();
    }
    writer->Write();
  }
}
} // namespace VTKTestFiles

#endif
