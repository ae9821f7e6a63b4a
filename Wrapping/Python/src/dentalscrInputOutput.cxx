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
#include "dentalscrConversions.h"
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
      py::arg("fileName"),
      "Sets the name of the file.")
    .def(
      "GetFileName",
      [](const ReaderType & self) { return std::string(self.GetFileName()); },
      "Returns the name of the file.")
    .def("SetFileFormat",
         &ReaderType::SetFileFormat,
         py::arg("format"),
         "Sets the format of the file; Automatic, the default, tells it by what is in it.")
    .def("GetFileFormat",
         &ReaderType::GetFileFormat,
         "Returns the format of the file; Automatic, the default, tells it by what is in it.")
    .def("SetNumbering",
         &ReaderType::SetNumbering,
         py::arg("numbering"),
         "Sets how the file numbers teeth, where its codes leave it open.")
    .def(
      "GetNumbering", &ReaderType::GetNumbering, "Returns how the file numbers teeth, where its codes leave it open.")
    .def(
      "SetImageFileName",
      [](ReaderType & self, const std::string & fileName) { self.SetImageFileName(fileName); },
      py::arg("fileName"),
      "Sets the name of the radiograph whose annotation is wanted, where a file holds those of "
      "several.")
    .def(
      "GetImageFileName",
      [](const ReaderType & self) { return std::string(self.GetImageFileName()); },
      "Returns the name of the radiograph whose annotation is wanted, where a file holds those of "
      "several.")
    .def("SetPixelOrigin",
         &ReaderType::SetPixelOrigin,
         py::arg("origin"),
         "Sets where (0, 0) is in the file: at the centre or the corner of the first pixel. "
         "FormatDefault, the default, is as its program counts.")
    .def("GetPixelOrigin",
         &ReaderType::GetPixelOrigin,
         "Returns where (0, 0) is in the file: at the centre or the corner of the first pixel. "
         "FormatDefault, the default, is as its program counts.")
    .def("SetMarkupsSpacing",
         &ReaderType::SetMarkupsSpacing,
         py::arg("spacing"),
         "Sets the spacing (u, v) of the image that a Slicer markups file was drawn on, mm a pixel.")
    .def(
      "GetMarkupsSpacing",
      [](const ReaderType & self) { return self.GetMarkupsSpacing(); },
      "Returns the spacing (u, v) of the image that a Slicer markups file was drawn on, mm a pixel.")
    .def("SetMarkupsOrigin",
         &ReaderType::SetMarkupsOrigin,
         py::arg("origin"),
         "Sets the origin (x, y) of the image that a Slicer markups file was drawn on, mm.")
    .def(
      "GetMarkupsOrigin",
      [](const ReaderType & self) { return self.GetMarkupsOrigin(); },
      "Returns the origin (x, y) of the image that a Slicer markups file was drawn on, mm.")
    .def("GetReadFileFormat", &ReaderType::GetReadFileFormat, "The format that was read, valid after Execute().")
    .def("GetWarnings",
         &ReaderType::GetWarnings,
         "What a person should know of the file, a sentence each, valid after Execute().")
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
      py::arg("fileName"),
      "Sets the name of the file.")
    .def(
      "GetFileName",
      [](const WriterType & self) { return std::string(self.GetFileName()); },
      "Returns the name of the file.")
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
                         { "WebCeph", FormatEnum::WebCeph },
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
      py::arg("fileName"),
      "Sets the name of the file. To set it takes back SetClassFiles().")
    .def(
      "GetFileName",
      [](const ContourReaderType & self) { return std::string(self.GetFileName()); },
      "Returns the name of the file. To set it takes back SetClassFiles().")
    .def("SetFileFormat",
         &ContourReaderType::SetFileFormat,
         py::arg("format"),
         "Sets the format of the file; Automatic, the default, tells it by what is in it.")
    .def("GetFileFormat",
         &ContourReaderType::GetFileFormat,
         "Returns the format of the file; Automatic, the default, tells it by what is in it.")
    .def("SetNumbering",
         &ContourReaderType::SetNumbering,
         py::arg("numbering"),
         "Sets how the file numbers teeth, where its codes leave it open.")
    .def("GetNumbering",
         &ContourReaderType::GetNumbering,
         "Returns how the file numbers teeth, where its codes leave it open.")
    .def("SetImageSize",
         &ContourReaderType::SetImageSize,
         py::arg("size"),
         "Sets the width and height of the radiograph, pixels; (0, 0), the default, is unknown, and "
         "the file has to say it.")
    .def(
      "GetImageSize",
      [](const ContourReaderType & self) { return self.GetImageSize(); },
      "Returns the width and height of the radiograph, pixels; (0, 0), the default, is unknown, "
      "and the file has to say it.")
    .def(
      "SetImageFileName",
      [](ContourReaderType & self, const std::string & fileName) { self.SetImageFileName(fileName); },
      py::arg("fileName"),
      "Sets the name of the radiograph whose tracing is wanted, where a file holds those of "
      "several.")
    .def(
      "GetImageFileName",
      [](const ContourReaderType & self) { return std::string(self.GetImageFileName()); },
      "Returns the name of the radiograph whose tracing is wanted, where a file holds those of "
      "several.")
    .def("SetClassFiles",
         &ContourReaderType::SetClassFiles,
         py::arg("files"),
         "Sets the files of one tooth or jaw each (masks, drawn lines, what a program drew) that are "
         "read in place of one file; none by default.")
    .def("GetClassFiles",
         &ContourReaderType::GetClassFiles,
         "Returns the files of one tooth or jaw each (masks, drawn lines, what a program drew) that "
         "are read in place of one file; none by default.")
    .def("SetSidelessCodesAreLeft",
         &ContourReaderType::SetSidelessCodesAreLeft,
         py::arg("on"),
         "Sets whether codes that do not say a side (U1, L6) are the left teeth. Off by default: "
         "right.")
    .def("GetSidelessCodesAreLeft",
         &ContourReaderType::GetSidelessCodesAreLeft,
         "Returns whether codes that do not say a side (U1, L6) are the left teeth. Off by default: "
         "right.")
    .def("SetPixelOrigin",
         &ContourReaderType::SetPixelOrigin,
         py::arg("origin"),
         "Sets where (0, 0) is in the file: at the centre or the corner of the first pixel. "
         "FormatDefault, the default, is as its program counts.")
    .def("GetPixelOrigin",
         &ContourReaderType::GetPixelOrigin,
         "Returns where (0, 0) is in the file: at the centre or the corner of the first pixel. "
         "FormatDefault, the default, is as its program counts.")
    .def("SetMarkupsSpacing",
         &ContourReaderType::SetMarkupsSpacing,
         py::arg("spacing"),
         "Sets the spacing (u, v) of the image that a Slicer markups file was drawn on, mm a pixel.")
    .def(
      "GetMarkupsSpacing",
      [](const ContourReaderType & self) { return self.GetMarkupsSpacing(); },
      "Returns the spacing (u, v) of the image that a Slicer markups file was drawn on, mm a pixel.")
    .def("SetMarkupsOrigin",
         &ContourReaderType::SetMarkupsOrigin,
         py::arg("origin"),
         "Sets the origin (x, y) of the image that a Slicer markups file was drawn on, mm.")
    .def(
      "GetMarkupsOrigin",
      [](const ContourReaderType & self) { return self.GetMarkupsOrigin(); },
      "Returns the origin (x, y) of the image that a Slicer markups file was drawn on, mm.")
    .def(
      "GetReadImageSize",
      [](const ContourReaderType & self) { return self.GetReadImageSize(); },
      "Width and height of the radiograph, pixels, as set or as the file says, valid after "
      "Execute().")
    .def("GetReadFileFormat", &ContourReaderType::GetReadFileFormat, "The format that was read, valid after Execute().")
    .def("GetReadNumbering",
         &ContourReaderType::GetReadNumbering,
         "The numbering under which the codes were read, valid after Execute().")
    .def("GetNumberOfPointsOutside",
         &ContourReaderType::GetNumberOfPointsOutside,
         "How many points of both jaws lie outside the radiograph, valid after Execute().")
    .def("GetNumberOfSidelessCodes",
         &ContourReaderType::GetNumberOfSidelessCodes,
         "How many contours have a code without a side, valid after Execute().")
    .def(
      "GetCalibrations",
      [](const ContourReaderType & self) {
        std::vector<std::tuple<std::string, double, double>> calibrations;
        for (const auto & line : self.GetCalibrations())
        {
          calibrations.emplace_back(line.label, line.millimetres, line.pixels);
        }
        return calibrations;
      },
      "What was drawn along rulers: (label, length in mm, length in pixels) each, valid after "
      "Execute().")
    .def("GetWarnings",
         &ContourReaderType::GetWarnings,
         "What a person should know of the file, a sentence each, valid after Execute().")
    .def("_TakeOutputs", [](ContourReaderType & self) {
      return std::make_pair(Detach(self.GetUpperOutput()), Detach(self.GetLowerOutput()));
    });

  ProcessClass<ContourWriterType>(module, "DentalContourFileWriter", "Writes a tracing as contours.json.")
    .def(New<ContourWriterType>())
    .def(
      "SetFileName",
      [](ContourWriterType & self, const std::string & fileName) { self.SetFileName(fileName); },
      py::arg("fileName"),
      "Sets the name of the file.")
    .def(
      "GetFileName",
      [](const ContourWriterType & self) { return std::string(self.GetFileName()); },
      "Returns the name of the file.")
    .def("_SetUpper", &ContourWriterType::SetUpper, py::arg("contour"))
    .def("_SetLower", &ContourWriterType::SetLower, py::arg("contour"))
    .def("SetImageSize",
         &ContourWriterType::SetImageSize,
         py::arg("size"),
         "Sets the width and height of the radiograph, pixels, which the file has to say.")
    .def(
      "GetImageSize",
      [](const ContourWriterType & self) { return self.GetImageSize(); },
      "Returns the width and height of the radiograph, pixels, which the file has to say.")
    .def("SetNumbering",
         &ContourWriterType::SetNumbering,
         py::arg("numbering"),
         "Sets how the file numbers teeth; Quadrant by default.")
    .def("GetNumbering", &ContourWriterType::GetNumbering, "Returns how the file numbers teeth; Quadrant by default.");

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
      py::arg("fileName"),
      "Sets the name of the image file.")
    .def(
      "GetFileName",
      [](const CephalogramReaderType & self) { return std::string(self.GetFileName()); },
      "Returns the name of the image file.")
    .def("SetUserPixelSpacing",
         &CephalogramReaderType::SetUserPixelSpacing,
         py::arg("spacing"),
         py::arg_v("plane", PlaneEnum::Detector, "SpacingPlane.Detector"),
         "Sets the pixel spacing (u, v), mm, and the plane in which it holds, over what the file says.")
    .def("ClearUserPixelSpacing",
         &CephalogramReaderType::ClearUserPixelSpacing,
         "Goes back to the spacing that the file says.")
    .def("GetPixelSpacingVerdict",
         &CephalogramReaderType::GetPixelSpacingVerdict,
         "What the pixel spacing of the file is worth, valid after Execute().")
    .def("GetSpacingPlane",
         &CephalogramReaderType::GetSpacingPlane,
         "The plane in which the pixel spacing holds, valid after Execute().")
    .def("HasPixelSpacing",
         &CephalogramReaderType::HasPixelSpacing,
         "Whether a pixel spacing is known, valid after Execute().")
    .def("GetPixelSpacing", &CephalogramReaderType::GetPixelSpacing, "Raises where the verdict is Unknown.")
    .def("GetDetectorPixelSpacing",
         &CephalogramReaderType::GetDetectorPixelSpacing,
         py::arg("sourceToDetector"),
         py::arg("sourceToMidsagittal"),
         "The spacing (u, v) in the detector plane, mm. One that holds in the midsagittal plane is "
         "multiplied by the ratio of the two distances from the source (mm); of EstimatedMagnification it "
         "is the file's imager pixel spacing, whatever the distances. It raises an error where the "
         "verdict is Unknown.")
    .def("HasSourceToDetectorDistance",
         &CephalogramReaderType::HasSourceToDetectorDistance,
         "Whether the file says the distance from source to detector.")
    .def("GetSourceToDetectorDistance",
         &CephalogramReaderType::GetSourceToDetectorDistance,
         "Distance from source to detector, mm, DICOM (0018,1110). It raises an error where there is "
         "none.")
    .def("HasSourceToMidsagittalDistance",
         &CephalogramReaderType::HasSourceToMidsagittalDistance,
         "Whether the file says what the distance from source to midsagittal plane follows from.")
    .def("GetSourceToMidsagittalDistance",
         &CephalogramReaderType::GetSourceToMidsagittalDistance,
         "Distance from source to midsagittal plane, mm: DICOM (0018,1110) over (0018,1114). It "
         "raises an error where one of them is missing.")
    .def("HasMagnificationFactor",
         &CephalogramReaderType::HasMagnificationFactor,
         "Whether the file says a magnification.")
    .def("GetMagnificationFactor",
         &CephalogramReaderType::GetMagnificationFactor,
         "The magnification, DICOM (0018,1114), no unit. It raises an error where there is none.")
    .def("HasFacing", &CephalogramReaderType::HasFacing, "Whether the file says to which side the face looks.")
    .def("GetFacing",
         &CephalogramReaderType::GetFacing,
         "The side of the image to which the face looks, from DICOM (0020,0020). It raises an error "
         "where that is missing.")
    .def("GetProvenance", &CephalogramReaderType::GetProvenance, "Where the pixel spacing comes from, in words.")
    .def("GetWarnings", &CephalogramReaderType::GetWarnings, "What a person should know of the file, a sentence each.")
    .def("GetFileFormat",
         &CephalogramReaderType::GetFileFormat,
         "The format that was read: \"PNG\", \"JPEG\", \"TIFF\", \"BMP\", \"NRRD\", \"MetaImage\", "
         "\"NIfTI\" or \"DICOM\".")
    .def("_TakeOutput", [](CephalogramReaderType & self) { return Detach(self.GetOutput()); });

  ProcessClass<LabelReaderType>(module, "ToothLabelFileReader", "Reads tooth labels of a mesh's points.")
    .def(New<LabelReaderType>())
    .def(
      "SetFileName",
      [](LabelReaderType & self, const std::string & fileName) { self.SetFileName(fileName); },
      py::arg("fileName"),
      "Sets the name of the file.")
    .def(
      "GetFileName",
      [](const LabelReaderType & self) { return std::string(self.GetFileName()); },
      "Returns the name of the file.")
    .def("SetNumbering",
         &LabelReaderType::SetNumbering,
         py::arg("numbering"),
         "Sets how the file numbers teeth: FDI (the default) or Universal.")
    .def("GetNumbering",
         &LabelReaderType::GetNumbering,
         "Returns how the file numbers teeth: FDI (the default) or Universal.")
    .def("SetNumberOfPoints",
         &LabelReaderType::SetNumberOfPoints,
         py::arg("count"),
         "Sets the number of points of the mesh that is labelled; 0, the default, checks nothing.")
    .def("GetNumberOfPoints",
         &LabelReaderType::GetNumberOfPoints,
         "Returns the number of points of the mesh that is labelled; 0, the default, checks nothing.")
    .def("GetJaw",
         &LabelReaderType::GetJaw,
         "The jaw, as the file says, else as its labels do; Unknown where neither does. Valid after "
         "Execute().")
    .def("_GetOutput", [](const LabelReaderType & self) { return MakeArray(self.GetLabels()); });
}
} // namespace dentalscr
