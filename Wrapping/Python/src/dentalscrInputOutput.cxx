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
#include "dentalscrLandmarks.h"

#include "itkCephalogramFileReader.h"
#include "itkCephalometricLandmarkFileReader.h"
#include "itkDentalContourFileReader.h"
#include "itkDentalContourFileWriter.h"
#include "itkDentalLandmarkFileReader.h"
#include "itkDentalLandmarkFileWriter.h"
#include "itkReadDentalMesh.h"
#include "itkToothLabelFileReader.h"

#include <string>
#include <tuple>
#include <vector>

namespace dentalscr
{
namespace
{
using ContourReaderType = itk::DentalContourFileReader;
using ContourWriterType = itk::DentalContourFileWriter;
using CephalogramReaderType = itk::CephalogramFileReader;
using LabelReaderType = itk::ToothLabelFileReader;

template <typename TOutput>
itk::SmartPointer<TOutput>
Detach(TOutput * output)
{
  itk::SmartPointer<TOutput> result = output;
  result->DisconnectPipeline();
  return result;
}

/** What readers of landmarks share. */
template <typename ReaderType>
void
WrapLandmarkReader(py::module_ & module, const char * name, const char * description)
{
  ProcessClass<ReaderType>(module, name, description)
    .def(New<ReaderType>())
    .def(
      "SetFileName",
      [](ReaderType & self, const std::string & fileName) { self.SetFileName(fileName); },
      py::arg("fileName"))
    .def("GetFileName", [](const ReaderType & self) { return std::string(self.GetFileName()); })
    .def("SetFileFormat", &ReaderType::SetFileFormat, py::arg("format"))
    .def("GetFileFormat", &ReaderType::GetFileFormat)
    .def("SetNumbering", &ReaderType::SetNumbering, py::arg("numbering"))
    .def("GetNumbering", &ReaderType::GetNumbering)
    .def(
      "SetImageFileName",
      [](ReaderType & self, const std::string & fileName) { self.SetImageFileName(fileName); },
      py::arg("fileName"))
    .def("GetImageFileName", [](const ReaderType & self) { return std::string(self.GetImageFileName()); })
    .def("SetPixelOrigin", &ReaderType::SetPixelOrigin, py::arg("origin"))
    .def("GetPixelOrigin", &ReaderType::GetPixelOrigin)
    .def("SetMarkupsSpacing", &ReaderType::SetMarkupsSpacing, py::arg("spacing"))
    .def("GetMarkupsSpacing", [](const ReaderType & self) { return self.GetMarkupsSpacing(); })
    .def("SetMarkupsOrigin", &ReaderType::SetMarkupsOrigin, py::arg("origin"))
    .def("GetMarkupsOrigin", [](const ReaderType & self) { return self.GetMarkupsOrigin(); })
    .def("GetReadFileFormat", &ReaderType::GetReadFileFormat)
    .def("GetWarnings", &ReaderType::GetWarnings)
    .def("_GetOutput", [](ReaderType & self) { return ToDict(self.GetOutput()); });
}

template <unsigned int VDimension>
void
WrapLandmarkFiles(py::module_ & module, const char * readerName, const char * writerName)
{
  using WriterType = itk::DentalLandmarkFileWriter<VDimension>;
  WrapLandmarkReader<itk::DentalLandmarkFileReader<VDimension>>(
    module, readerName, "Reads named landmarks; see ReadLandmarks().");
  ProcessClass<WriterType>(module, writerName, "Writes named landmarks; see WriteLandmarks().")
    .def(New<WriterType>())
    .def(
      "SetFileName",
      [](WriterType & self, const std::string & fileName) { self.SetFileName(fileName); },
      py::arg("fileName"))
    .def("GetFileName", [](const WriterType & self) { return std::string(self.GetFileName()); })
    .def(
      "_SetInput",
      [](WriterType & self, const py::dict & landmarks) { self.SetInput(FromDict<VDimension>(landmarks)); },
      py::arg("landmarks"));
}
} // namespace

void
WrapInputOutput(py::module_ & module)
{
  using FormatEnum = itk::AnnotationFileFormatEnum;
  BindEnum<FormatEnum>(module,
                       "AnnotationFileFormat",
                       { { "Automatic", FormatEnum::Automatic },
                         { "DentalSCR", FormatEnum::DentalSCR },
                         { "SlicerMarkups", FormatEnum::SlicerMarkups },
                         { "Labelme", FormatEnum::Labelme },
                         { "CSV", FormatEnum::CSV },
                         { "Aariz", FormatEnum::Aariz },
                         { "LandmarkDetector", FormatEnum::LandmarkDetector },
                         { "CLDetection", FormatEnum::CLDetection },
                         { "ISBI2015", FormatEnum::ISBI2015 },
                         { "CVAT", FormatEnum::CVAT },
                         { "COCO", FormatEnum::COCO },
                         { "VIA", FormatEnum::VIA },
                         { "LabelStudio", FormatEnum::LabelStudio },
                         { "Supervisely", FormatEnum::Supervisely },
                         { "LabelImage", FormatEnum::LabelImage } },
                       "What an annotation file is written in.");
  using OriginEnum = itk::AnnotationPixelOriginEnum;
  BindEnum<OriginEnum>(module,
                       "AnnotationPixelOrigin",
                       { { "FormatDefault", OriginEnum::FormatDefault },
                         { "Centre", OriginEnum::Centre },
                         { "Corner", OriginEnum::Corner } },
                       "Where a 2-D annotation's (0, 0) is: in the first pixel's centre or corner.");
  using VerdictEnum = itk::PixelSpacingVerdictEnum;
  BindEnum<VerdictEnum>(module,
                        "PixelSpacingVerdict",
                        { { "Detector", VerdictEnum::Detector },
                          { "Calibrated", VerdictEnum::Calibrated },
                          { "EstimatedMagnification", VerdictEnum::EstimatedMagnification },
                          { "Unknown", VerdictEnum::Unknown },
                          { "UserGiven", VerdictEnum::UserGiven } },
                        "What a radiograph's pixel spacing is worth.");
  using PlaneEnum = itk::SpacingPlaneEnum;
  BindEnum<PlaneEnum>(module,
                      "SpacingPlane",
                      { { "Detector", PlaneEnum::Detector },
                        { "Midsagittal", PlaneEnum::Midsagittal },
                        { "Unknown", PlaneEnum::Unknown } },
                      "The plane in which a pixel spacing holds.");

  module.def(
    "_ReadMesh",
    [](const std::string & fileName) { return itk::ReadDentalMesh<MeshType>(fileName); },
    py::arg("fileName"),
    py::call_guard<py::gil_scoped_release>());
  module.def(
    "_WriteMesh",
    [](const MeshType & mesh, const std::string & fileName) { itk::WriteDentalMesh<MeshType>(&mesh, fileName); },
    py::arg("mesh"),
    py::arg("fileName"),
    py::call_guard<py::gil_scoped_release>());

  ProcessClass<ContourReaderType>(module, "DentalContourFileReader", "Reads the tracing on a radiograph.")
    .def(New<ContourReaderType>())
    .def(
      "SetFileName",
      [](ContourReaderType & self, const std::string & fileName) { self.SetFileName(fileName); },
      py::arg("fileName"))
    .def("GetFileName", [](const ContourReaderType & self) { return std::string(self.GetFileName()); })
    .def("SetFileFormat", &ContourReaderType::SetFileFormat, py::arg("format"))
    .def("GetFileFormat", &ContourReaderType::GetFileFormat)
    .def("SetNumbering", &ContourReaderType::SetNumbering, py::arg("numbering"))
    .def("GetNumbering", &ContourReaderType::GetNumbering)
    .def("SetImageSize", &ContourReaderType::SetImageSize, py::arg("size"))
    .def("GetImageSize", [](const ContourReaderType & self) { return self.GetImageSize(); })
    .def(
      "SetImageFileName",
      [](ContourReaderType & self, const std::string & fileName) { self.SetImageFileName(fileName); },
      py::arg("fileName"))
    .def("GetImageFileName", [](const ContourReaderType & self) { return std::string(self.GetImageFileName()); })
    .def("SetClassFiles", &ContourReaderType::SetClassFiles, py::arg("files"))
    .def("GetClassFiles", &ContourReaderType::GetClassFiles)
    .def("SetSidelessCodesAreLeft", &ContourReaderType::SetSidelessCodesAreLeft, py::arg("on"))
    .def("GetSidelessCodesAreLeft", &ContourReaderType::GetSidelessCodesAreLeft)
    .def("SetPixelOrigin", &ContourReaderType::SetPixelOrigin, py::arg("origin"))
    .def("GetPixelOrigin", &ContourReaderType::GetPixelOrigin)
    .def("SetMarkupsSpacing", &ContourReaderType::SetMarkupsSpacing, py::arg("spacing"))
    .def("GetMarkupsSpacing", [](const ContourReaderType & self) { return self.GetMarkupsSpacing(); })
    .def("SetMarkupsOrigin", &ContourReaderType::SetMarkupsOrigin, py::arg("origin"))
    .def("GetMarkupsOrigin", [](const ContourReaderType & self) { return self.GetMarkupsOrigin(); })
    .def("GetReadImageSize", [](const ContourReaderType & self) { return self.GetReadImageSize(); })
    .def("GetReadFileFormat", &ContourReaderType::GetReadFileFormat)
    .def("GetReadNumbering", &ContourReaderType::GetReadNumbering)
    .def("GetNumberOfPointsOutside", &ContourReaderType::GetNumberOfPointsOutside)
    .def("GetNumberOfSidelessCodes", &ContourReaderType::GetNumberOfSidelessCodes)
    .def("GetCalibrations",
         [](const ContourReaderType & self) {
           std::vector<std::tuple<std::string, double, double>> calibrations;
           for (const auto & line : self.GetCalibrations())
           {
             calibrations.emplace_back(line.label, line.millimetres, line.pixels);
           }
           return calibrations;
         })
    .def("GetWarnings", &ContourReaderType::GetWarnings)
    .def("_TakeOutputs", [](ContourReaderType & self) {
      return std::make_pair(Detach(self.GetUpperOutput()), Detach(self.GetLowerOutput()));
    });

  ProcessClass<ContourWriterType>(module, "DentalContourFileWriter", "Writes a tracing as contours.json.")
    .def(New<ContourWriterType>())
    .def(
      "SetFileName",
      [](ContourWriterType & self, const std::string & fileName) { self.SetFileName(fileName); },
      py::arg("fileName"))
    .def("GetFileName", [](const ContourWriterType & self) { return std::string(self.GetFileName()); })
    .def("_SetUpper", &ContourWriterType::SetUpper, py::arg("contour"))
    .def("_SetLower", &ContourWriterType::SetLower, py::arg("contour"))
    .def("SetImageSize", &ContourWriterType::SetImageSize, py::arg("size"))
    .def("GetImageSize", [](const ContourWriterType & self) { return self.GetImageSize(); })
    .def("SetNumbering", &ContourWriterType::SetNumbering, py::arg("numbering"))
    .def("GetNumbering", &ContourWriterType::GetNumbering);

  WrapLandmarkFiles<2>(module, "DentalLandmarkFileReader2D", "DentalLandmarkFileWriter2D");
  WrapLandmarkFiles<3>(module, "DentalLandmarkFileReader3D", "DentalLandmarkFileWriter3D");

  WrapLandmarkReader<itk::CephalometricLandmarkFileReader>(
    module,
    "CephalometricLandmarkFileReader",
    "Reads the dental landmarks of a cephalometric analysis; see ReadCephalometricLandmarks().");

  ProcessClass<CephalogramReaderType>(
    module, "CephalogramFileReader", "Reads a radiograph and says what its pixel spacing is worth.")
    .def(New<CephalogramReaderType>())
    .def(
      "SetFileName",
      [](CephalogramReaderType & self, const std::string & fileName) { self.SetFileName(fileName); },
      py::arg("fileName"))
    .def("GetFileName", [](const CephalogramReaderType & self) { return std::string(self.GetFileName()); })
    .def("SetUserPixelSpacing",
         &CephalogramReaderType::SetUserPixelSpacing,
         py::arg("spacing"),
         py::arg_v("plane", PlaneEnum::Detector, "SpacingPlane.Detector"))
    .def("ClearUserPixelSpacing", &CephalogramReaderType::ClearUserPixelSpacing)
    .def("GetPixelSpacingVerdict", &CephalogramReaderType::GetPixelSpacingVerdict)
    .def("GetSpacingPlane", &CephalogramReaderType::GetSpacingPlane)
    .def("HasPixelSpacing", &CephalogramReaderType::HasPixelSpacing)
    .def("GetPixelSpacing", &CephalogramReaderType::GetPixelSpacing, "Raises where the verdict is Unknown.")
    .def("GetDetectorPixelSpacing",
         &CephalogramReaderType::GetDetectorPixelSpacing,
         py::arg("sourceToDetector"),
         py::arg("sourceToMidsagittal"))
    .def("HasSourceToDetectorDistance", &CephalogramReaderType::HasSourceToDetectorDistance)
    .def("GetSourceToDetectorDistance", &CephalogramReaderType::GetSourceToDetectorDistance)
    .def("HasSourceToMidsagittalDistance", &CephalogramReaderType::HasSourceToMidsagittalDistance)
    .def("GetSourceToMidsagittalDistance", &CephalogramReaderType::GetSourceToMidsagittalDistance)
    .def("HasMagnificationFactor", &CephalogramReaderType::HasMagnificationFactor)
    .def("GetMagnificationFactor", &CephalogramReaderType::GetMagnificationFactor)
    .def("HasFacing", &CephalogramReaderType::HasFacing)
    .def("GetFacing", &CephalogramReaderType::GetFacing)
    .def("GetProvenance", &CephalogramReaderType::GetProvenance)
    .def("GetWarnings", &CephalogramReaderType::GetWarnings)
    .def("GetFileFormat", &CephalogramReaderType::GetFileFormat)
    .def("_TakeOutput", [](CephalogramReaderType & self) { return Detach(self.GetOutput()); });

  ProcessClass<LabelReaderType>(module, "ToothLabelFileReader", "Reads tooth labels of a mesh's points.")
    .def(New<LabelReaderType>())
    .def(
      "SetFileName",
      [](LabelReaderType & self, const std::string & fileName) { self.SetFileName(fileName); },
      py::arg("fileName"))
    .def("GetFileName", [](const LabelReaderType & self) { return std::string(self.GetFileName()); })
    .def("SetNumbering", &LabelReaderType::SetNumbering, py::arg("numbering"))
    .def("GetNumbering", &LabelReaderType::GetNumbering)
    .def("SetNumberOfPoints", &LabelReaderType::SetNumberOfPoints, py::arg("count"))
    .def("GetNumberOfPoints", &LabelReaderType::GetNumberOfPoints)
    .def("GetJaw", &LabelReaderType::GetJaw)
    .def("_GetOutput", [](const LabelReaderType & self) { return MakeArray(self.GetLabels()); });
}
} // namespace dentalscr
