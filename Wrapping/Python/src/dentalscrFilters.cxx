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
#include "dentalscrBinding.h"

#include "itkContourMaskFilter.h"
#include "itkContourResampleFilter.h"
#include "itkCrownRegionMeshFilter.h"
#include "itkMeshSilhouetteContourSource.h"
#include "itkMidlineSideMeshFilter.h"
#include "itkMidsagittalPlaneFilter.h"
#include "itkOpenSilhouetteContourSource.h"
#include "itkSilhouetteContourFilter.h"
#include "itkSurfaceDRRImageSource.h"
#include "itkUMidlineDentalAxisFilter.h"

namespace dentalscr
{
namespace
{
using AxisType = itk::UMidlineDentalAxisFilter<MeshType>;
using PlaneFilterType = itk::MidsagittalPlaneFilter<MeshType>;
using DRRType = itk::SurfaceDRRImageSource<MeshType, ImageType>;
using SilhouetteType = itk::SilhouetteContourFilter<ImageType>;
using MeshSilhouetteType = itk::MeshSilhouetteContourSource<MeshType>;
using ResampleType = itk::ContourResampleFilter;
using CrownType = itk::CrownRegionMeshFilter<MeshType>;
using SideType = itk::MidlineSideMeshFilter<MeshType>;
using RigidType = itk::VersorRigid3DTransform<double>;
using JawEnum = itk::ToothCode::JawEnum;

template <typename TOutput>
itk::SmartPointer<TOutput>
Detach(TOutput * output)
{
  itk::SmartPointer<TOutput> result = output;
  result->DisconnectPipeline();
  return result;
}

itk::UMidlineDentalAxisFilterEnums::Jaw
ToAxisJaw(JawEnum jaw)
{
  if (jaw == JawEnum::Unknown)
  {
    throw std::invalid_argument("a jaw is Upper or Lower here");
  }
  return jaw == JawEnum::Upper ? itk::UMidlineDentalAxisFilterEnums::Jaw::Upper
                               : itk::UMidlineDentalAxisFilterEnums::Jaw::Lower;
}

py::array_t<double>
ToArray(const std::array<double, 3> & values)
{
  return MakeArray<double>(std::vector<double>(values.begin(), values.end()));
}

py::dict
ToDict(const itk::MidsagittalPlaneResult & plane)
{
  py::dict result;
  result["valid"] = plane.valid;
  result["normal"] = ToArray(plane.normal);
  result["offset"] = plane.offset;
  result["residual"] = plane.residual;
  result["inlierFraction"] = plane.inlierFraction;
  result["margin"] = plane.margin;
  return result;
}

void
WrapAxis(py::module_ & module)
{
  using ShareEnum = itk::DentalFrameEnums::JawsShareFrame;
  BindEnum<ShareEnum>(module,
                      "JawsShareFrame",
                      { { "Off", ShareEnum::Off }, { "On", ShareEnum::On }, { "Check", ShareEnum::Check } },
                      "Whether two scans share a frame in occlusion: said, or tested.");
  using FramesType = itk::DentalFrameObject;
  py::class_<FramesType, FramesType::Pointer>(
    module, "DentalFrames", "Everything that UMidlineDentalAxisFilter found, for ScanCheckFilter to judge.");
  ProcessClass<AxisType>(module, "UMidlineDentalAxisFilter", "The anatomical frame of dental arches.")
    .def(New<AxisType>())
    .def("_SetUpperMesh", &AxisType::SetUpperMesh, py::arg("mesh"))
    .def("_SetLowerMesh", &AxisType::SetLowerMesh, py::arg("mesh"))
    .def("SetJawsShareFrame", &AxisType::SetJawsShareFrame, py::arg("mode"))
    .def("GetJawsShareFrame", &AxisType::GetJawsShareFrame)
    .dentalscrProperty(AxisType, CrownFraction)
    .dentalscrProperty(AxisType, MaximumIterations)
    .dentalscrBoolean(AxisType, RefineMidline)
    .dentalscrBoolean(AxisType, EmbedAxes)
    .dentalscrProperty(AxisType, AxesLength)
    .dentalscrBoolean(AxisType, TransformMeshes)
    .dentalscrBoolean(AxisType, RequireArches)
    .def("_TakeMesh",
         [](AxisType & self, JawEnum jaw) {
           return Detach(jaw == JawEnum::Lower ? self.GetLowerOutput() : self.GetUpperOutput());
         })
    .def("_GetFrames",
         [](AxisType & self) {
           // A copy: the next Execute() does not change it.
           auto frames = FramesType::New();
           frames->Set(self.GetFrame());
           return frames;
         })
    .def(
      "_GetTransform",
      [](AxisType & self, JawEnum jaw) -> RigidType::Pointer {
        // Itself, as a copy by its parameters may differ in the last bit; the next run makes another.
        switch (jaw)
        {
          case JawEnum::Upper:
            return self.GetUpperTransformOutput()->GetModifiable();
          case JawEnum::Lower:
            return self.GetLowerTransformOutput()->GetModifiable();
          default:
            return self.GetJointTransformOutput()->GetModifiable();
        }
      },
      py::arg("jaw"),
      "Of both jaws together for Unknown.")
    .def(
      "GetBaselineRight",
      [](const AxisType & self, JawEnum jaw) { return self.GetBaselineRight(ToAxisJaw(jaw)); },
      py::arg("jaw"),
      "End of the molar baseline on the patient's right, mesh frame, mm.")
    .def(
      "GetBaselineLeft",
      [](const AxisType & self, JawEnum jaw) { return self.GetBaselineLeft(ToAxisJaw(jaw)); },
      py::arg("jaw"))
    .def(
      "GetBaselineMidpoint",
      [](const AxisType & self, JawEnum jaw) { return self.GetBaselineMidpoint(ToAxisJaw(jaw)); },
      py::arg("jaw"))
    .def(
      "GetIncisalEdge",
      [](const AxisType & self, JawEnum jaw) { return self.GetIncisalEdge(ToAxisJaw(jaw)); },
      py::arg("jaw"))
    .def(
      "GetArchWidth",
      [](const AxisType & self, JawEnum jaw) { return self.GetArchWidth(ToAxisJaw(jaw)); },
      py::arg("jaw"),
      "mm.")
    .def(
      "GetArchDepth",
      [](const AxisType & self, JawEnum jaw) { return self.GetArchDepth(ToAxisJaw(jaw)); },
      py::arg("jaw"),
      "mm.")
    .def(
      "GetConfidence",
      [](const AxisType & self, JawEnum jaw) { return self.GetConfidence(ToAxisJaw(jaw)); },
      py::arg("jaw"),
      "In [0, 1]; below 0.5 a person should look at the axes.")
    .def("GetJawsAreInOneFrame", &AxisType::GetJawsAreInOneFrame)
    .def("GetOverjet", &AxisType::GetOverjet, "mm; means something only where the jaws are in one frame.")
    .def("GetOverbite", &AxisType::GetOverbite, "mm; means something only where the jaws are in one frame.");

  ProcessClass<PlaneFilterType>(module, "MidsagittalPlaneFilter", "The mirror plane of one arch or of a pair.")
    .def(New<PlaneFilterType>())
    .def("_SetUpperMesh", &PlaneFilterType::SetUpperMesh, py::arg("mesh"))
    .def("_SetLowerMesh", &PlaneFilterType::SetLowerMesh, py::arg("mesh"))
    .def("_GetPlane", [](const PlaneFilterType & self) { return ToDict(self.GetPlaneOutput()->Get()); })
    .def("GetNormal", &PlaneFilterType::GetNormal)
    .def("GetOffset", &PlaneFilterType::GetOffset)
    .def("SignedDistance", &PlaneFilterType::SignedDistance, py::arg("point"));
}

void
WrapDRR(py::module_ & module)
{
  using NormalizationEnum = itk::SurfaceDRRImageSourceEnums::Normalization;
  using OutputEnum = itk::SurfaceDRRImageSourceEnums::Output;
  BindEnum<NormalizationEnum>(module,
                              "SurfaceDRRNormalization",
                              { { "Paper", NormalizationEnum::Paper }, { "Physical", NormalizationEnum::Physical } },
                              "What a splat weighs.");
  BindEnum<OutputEnum>(module,
                       "SurfaceDRROutput",
                       { { "Thickness", OutputEnum::Thickness },
                         { "Intensity", OutputEnum::Intensity },
                         { "InvertedIntensity", OutputEnum::InvertedIntensity } },
                       "What a pixel holds.");
  ProcessClass<DRRType>(module, "SurfaceDRRImageSource", "Digitally reconstructed radiograph of surfaces.")
    .def(New<DRRType>())
    .def(
      "_SetInput",
      [](DRRType & self, unsigned int number, const MeshType * mesh) { self.SetInput(number, mesh); },
      py::arg("number"),
      py::arg("mesh"))
    .def("_GetNumberOfMeshes", &DRRType::GetNumberOfMeshes)
    .def("_SetGeometry", &DRRType::SetGeometry, py::arg("geometry"))
    .dentalscrProperty(DRRType, Sigma)
    .def("SetMeshSigma", &DRRType::SetMeshSigma, py::arg("number"), py::arg("sigma"))
    .def("GetMeshSigma", &DRRType::GetMeshSigma, py::arg("number"))
    .def("SetVertexSigmas", &DRRType::SetVertexSigmas, py::arg("number"), py::arg("sigmas"))
    .def("GetVertexSigmas", &DRRType::GetVertexSigmas, py::arg("number"))
    .def("SetNormalization", &DRRType::SetNormalization, py::arg("normalization"))
    .def("GetNormalization", &DRRType::GetNormalization)
    .def("SetOutputMode", &DRRType::SetOutputMode, py::arg("mode"))
    .def("GetOutputMode", &DRRType::GetOutputMode)
    .dentalscrProperty(DRRType, Density)
    .dentalscrProperty(DRRType, SourceIntensity)
    .dentalscrProperty(DRRType, Attenuation)
    .dentalscrProperty(DRRType, Tolerance)
    .dentalscrBoolean(DRRType, UseGeometrySpacing)
    .def(
      "SetSize", [](DRRType & self, const itk::Size<2> & size) { self.SetSize(size); }, py::arg("size"))
    .def("GetSize", [](const DRRType & self) { return self.GetSize(); })
    .def(
      "SetStartIndex", [](DRRType & self, const itk::Index<2> & index) { self.SetStartIndex(index); }, py::arg("index"))
    .def("GetStartIndex", [](const DRRType & self) { return self.GetStartIndex(); })
    .def(
      "SetSpacing",
      [](DRRType & self, const itk::Vector<double, 2> & spacing) { self.SetSpacing(spacing); },
      py::arg("spacing"))
    .def("GetSpacing", [](const DRRType & self) { return itk::Vector<double, 2>(self.GetSpacing()); })
    .def(
      "SetOrigin",
      [](DRRType & self, const itk::Point<double, 2> & origin) { self.SetOrigin(origin); },
      py::arg("origin"))
    .def("GetOrigin", [](const DRRType & self) { return self.GetOrigin(); })
    .def(
      "_SetReferenceImage",
      [](DRRType & self, const ImageType * image) {
        self.SetReferenceImage(image);
        self.SetUseReferenceImage(image != nullptr);
      },
      py::arg("image"))
    .dentalscrBoolean(DRRType, CoverMeshes)
    .dentalscrProperty(DRRType, CoverMargin)
    .def("SetSizeToCoverMeshes", &DRRType::SetSizeToCoverMeshes, py::arg("margin"))
    .def(
      "_UpdateRegion",
      [](DRRType & self, const itk::Index<2> & index, const itk::Size<2> & size) {
        Run(&self, [&]() {
          self.UpdateOutputInformation();
          self.GetOutput()->SetRequestedRegion(ImageType::RegionType(index, size));
          self.GetOutput()->Update();
        });
        // A copy, so that the pipeline keeps its splats for the next strip.
        const ImageType * output = self.GetOutput();
        auto              image = ImageType::New();
        image->SetRegions(ImageType::RegionType(index, size));
        image->SetSpacing(output->GetSpacing());
        image->SetOrigin(output->GetOrigin());
        image->Allocate();
        const std::size_t width = size[0];
        for (std::size_t row = 0; row < size[1]; ++row)
        {
          const ImageType::IndexType first{ { index[0], index[1] + static_cast<itk::IndexValueType>(row) } };
          const float *              from = output->GetBufferPointer() + output->ComputeOffset(first);
          std::copy(from, from + width, image->GetBufferPointer() + row * width);
        }
        return image;
      },
      py::arg("index"),
      py::arg("size"))
    .def("_UpdateOutputInformation",
         [](DRRType & self) {
           Run(&self, [&]() { self.UpdateOutputInformation(); });
           const auto & region = self.GetOutput()->GetLargestPossibleRegion();
           return std::make_pair(region.GetIndex(), region.GetSize());
         })
    .def("_TakeOutput", [](DRRType & self) { return Detach(self.GetOutput()); })
    .def("GetNumberOfProjections", &DRRType::GetNumberOfProjections, "How often the splats were projected.");
}

void
WrapContours(py::module_ & module)
{
  using ContentEnum = itk::SilhouetteContourFilterEnums::Content;
  using LevelEnum = itk::SilhouetteContourFilterEnums::Level;
  using CoordinatesEnum = itk::SilhouetteContourFilterEnums::OutputCoordinates;
  BindEnum<ContentEnum>(module,
                        "SilhouetteContent",
                        { { "Intensity", ContentEnum::Intensity },
                          { "ToothLabels", ContentEnum::ToothLabels },
                          { "MergedLabels", ContentEnum::MergedLabels } },
                        "What the pixels are: grey values, FDI numbers, or labels of any meaning.");
  BindEnum<LevelEnum>(
    module,
    "SilhouetteLevel",
    { { "Absolute", LevelEnum::Absolute }, { "Fraction", LevelEnum::Fraction }, { "Automatic", LevelEnum::Automatic } },
    "How the level of grey values is found.");
  BindEnum<CoordinatesEnum>(module,
                            "SilhouetteCoordinates",
                            { { "Index", CoordinatesEnum::Index },
                              { "Physical", CoordinatesEnum::Physical },
                              { "PhysicalOverSpacing", CoordinatesEnum::PhysicalOverSpacing } },
                            "In what a contour is expressed.");
  ProcessClass<SilhouetteType>(module, "SilhouetteContourFilter", "The outer silhouette in an image, or of labels.")
    .def(New<SilhouetteType>())
    .def(
      "_SetInput", [](SilhouetteType & self, const ImageType * image) { self.SetInput(image); }, py::arg("image"))
    .def("SetContent", &SilhouetteType::SetContent, py::arg("content"))
    .def("GetContent", &SilhouetteType::GetContent)
    .def("SetLevel", &SilhouetteType::SetLevel, py::arg("level"))
    .def("GetLevel", &SilhouetteType::GetLevel)
    .dentalscrProperty(SilhouetteType, LevelValue)
    .dentalscrProperty(SilhouetteType, LevelFraction)
    .dentalscrBoolean(SilhouetteType, ObjectIsDark)
    .dentalscrBoolean(SilhouetteType, LargestPartOnly)
    .dentalscrProperty(SilhouetteType, MinimumArea)
    .dentalscrProperty(SilhouetteType, NumberOfStreamDivisions)
    .dentalscrProperty(SilhouetteType, LabelSmoothing)
    .def("SetOutputCoordinates", &SilhouetteType::SetOutputCoordinates, py::arg("coordinates"))
    .def("GetOutputCoordinates", &SilhouetteType::GetOutputCoordinates)
    .def("SetOutputOffset", &SilhouetteType::SetOutputOffset, py::arg("offset"))
    .def("GetOutputOffset", [](const SilhouetteType & self) { return self.GetOutputOffset(); })
    .def("GetUsedLevel", &SilhouetteType::GetUsedLevel, "Of the last Execute().")
    .def("_TakeOutput", [](SilhouetteType & self) { return Detach(self.GetOutput()); });

  ProcessClass<MeshSilhouetteType>(module, "MeshSilhouetteContourSource", "The exact outer silhouette of a mesh.")
    .def(New<MeshSilhouetteType>())
    .def(
      "_SetInput", [](MeshSilhouetteType & self, const MeshType * mesh) { self.SetInput(mesh); }, py::arg("mesh"))
    .def("_SetGeometry", &MeshSilhouetteType::SetGeometry, py::arg("geometry"))
    .dentalscrBoolean(MeshSilhouetteType, LargestPartOnly)
    .dentalscrProperty(MeshSilhouetteType, NumberOfPoints)
    .def("_GetSamples",
         [](const MeshSilhouetteType & self) {
           std::vector<std::array<double, 2>> normals;
           std::vector<std::array<double, 3>> rims;
           std::vector<double>                arcs;
           for (const auto & sample : self.GetSamples())
           {
             normals.push_back(sample.normal);
             rims.push_back(sample.rim);
             arcs.push_back(sample.arcLength);
           }
           return py::make_tuple(MakeRows<2>(normals), MakeRows<3>(rims), MakeArray(arcs));
         })
    .def("_TakeOutput", [](MeshSilhouetteType & self) { return Detach(self.GetOutput()); });

  using OpenType = itk::OpenSilhouetteContourSource<MeshType>;
  ProcessClass<OpenType>(
    module, "OpenSilhouetteContourSource", "The part of a jaw's outline that a tracing can lie on.")
    .def(New<OpenType>())
    .def(
      "_SetInput", [](OpenType & self, const MeshType * mesh) { self.SetInput(mesh); }, py::arg("mesh"))
    .def("_SetGeometry", &OpenType::SetGeometry, py::arg("geometry"))
    .def(
      "_SetFrameTransform",
      [](OpenType & self, const RigidType * transform) {
        if (transform == nullptr)
        {
          self.SetFrameTransformInput(nullptr);
        }
        else
        {
          self.SetFrameTransform(transform);
        }
      },
      py::arg("transform"))
    .def("SetJaw", &OpenType::SetJaw, py::arg("jaw"))
    .def("GetJaw", &OpenType::GetJaw)
    .dentalscrProperty(OpenType, Spacing)
    .def(
      "GetRimPoints",
      [](const OpenType & self) { return MakeRows<3>(self.GetRimPoints()); },
      "(N, 3), object frame, mm.")
    .def(
      "GetNormals", [](const OpenType & self) { return MakeRows<2>(self.GetNormals()); }, "(N, 2), outward.")
    .def("_TakeOutput", [](OpenType & self) { return Detach(self.GetOutput()); });

  using MaskType = itk::Image<unsigned char, 2>;
  using MaskFilterType = itk::ContourMaskFilter<MaskType>;
  ProcessClass<MaskFilterType>(module, "ContourMaskFilter", "The stretches of a contour that run through a mask.")
    .def(New<MaskFilterType>())
    .def(
      "_SetInput",
      [](MaskFilterType & self, const itk::DentalContour * contour) { self.SetInput(contour); },
      py::arg("contour"))
    .def(
      "_SetMaskImage",
      [](MaskFilterType & self, const ImageType & image) {
        auto mask = MaskType::New();
        mask->SetRegions(image.GetBufferedRegion());
        mask->Allocate();
        const auto pixels = image.GetBufferedRegion().GetNumberOfPixels();
        std::transform(image.GetBufferPointer(),
                       image.GetBufferPointer() + pixels,
                       mask->GetBufferPointer(),
                       [](float value) { return static_cast<unsigned char>(value != 0.0F); });
        self.SetMaskImage(mask);
      },
      py::arg("image"))
    .def("SetMinimumNumberOfPoints", &MaskFilterType::SetMinimumNumberOfPoints, py::arg("number"))
    .def("GetMinimumNumberOfPoints", &MaskFilterType::GetMinimumNumberOfPoints)
    .def("_TakeOutput", [](MaskFilterType & self) { return Detach(self.GetOutput()); });

  ProcessClass<ResampleType>(module, "ContourResampleFilter", "Points at equal distances along a contour.")
    .def(New<ResampleType>())
    .def(
      "_SetInput",
      [](ResampleType & self, const itk::DentalContour * contour) { self.SetInput(contour); },
      py::arg("contour"))
    .dentalscrProperty(ResampleType, NumberOfPoints)
    .dentalscrProperty(ResampleType, Spacing)
    .def("_TakeOutput", [](ResampleType & self) { return Detach(self.GetOutput()); });
}

void
WrapCrowns(py::module_ & module)
{
  ProcessClass<CrownType>(module, "CrownRegionMeshFilter", "The crowns of a scan.")
    .def(New<CrownType>())
    .def(
      "_SetInput", [](CrownType & self, const MeshType * mesh) { self.SetInput(mesh); }, py::arg("mesh"))
    .def(
      "_SetFrameTransform",
      [](CrownType & self, const RigidType * transform) {
        if (transform == nullptr)
        {
          self.SetFrameTransformInput(nullptr);
        }
        else
        {
          self.SetFrameTransform(transform);
        }
      },
      py::arg("transform"))
    .def(
      "SetJaw", [](CrownType & self, JawEnum jaw) { self.SetJaw(ToAxisJaw(jaw)); }, py::arg("jaw"))
    .def("GetJaw",
         [](const CrownType & self) {
           return self.GetJaw() == itk::UMidlineDentalAxisFilterEnums::Jaw::Upper ? JawEnum::Upper : JawEnum::Lower;
         })
    .dentalscrBoolean(CrownType, UseLabels)
    .def("SetLabelNumbering", &CrownType::SetLabelNumbering, py::arg("numbering"))
    .def("GetLabelNumbering", &CrownType::GetLabelNumbering)
    .dentalscrBoolean(CrownType, KeepWholeMesh)
    .dentalscrProperty(CrownType, MinimumCrownHeight)
    .dentalscrProperty(CrownType, MaximumCrownHeight)
    .def(
      "GetPointMask", [](const CrownType & self) { return MakeArray(self.GetPointMask()); }, "(N,) of 0 and 1.")
    .def(
      "GetTriangleMask", [](const CrownType & self) { return MakeArray(self.GetTriangleMask()); }, "(M,) of 0 and 1.")
    .def("GetCrownArea", &CrownType::GetCrownArea, "mm^2.")
    .def("GetMeanCrownHeight", &CrownType::GetMeanCrownHeight, "mm.")
    .def("GetMarginAngle", &CrownType::GetMarginAngle, "rad.")
    .def("GetLabelsWereUsed", &CrownType::GetLabelsWereUsed)
    .def("_TakeOutput", [](CrownType & self) { return Detach(self.GetOutput()); });

  using SideEnum = itk::MidlineSideMeshFilterEnums::Side;
  BindEnum<SideEnum>(
    module, "Side", { { "Right", SideEnum::Right }, { "Left", SideEnum::Left } }, "The patient's side.");
  ProcessClass<SideType>(module, "MidlineSideMeshFilter", "The part of a jaw on one side of the midline plane.")
    .def(New<SideType>())
    .def(
      "_SetInput", [](SideType & self, const MeshType * mesh) { self.SetInput(mesh); }, py::arg("mesh"))
    .def(
      "_SetFrameTransform",
      [](SideType & self, const RigidType & transform) { self.SetFrameTransform(&transform); },
      py::arg("transform"))
    .def("SetSide", &SideType::SetSide, py::arg("side"))
    .def("GetSide", &SideType::GetSide)
    .dentalscrProperty(SideType, Margin)
    .def(
      "GetTriangleMask", [](const SideType & self) { return MakeArray(self.GetTriangleMask()); }, "(M,) of 0 and 1.")
    .def("_TakeOutput", [](SideType & self) { return Detach(self.GetOutput()); });
}
} // namespace

void
WrapFilters(py::module_ & module)
{
  WrapAxis(module);
  WrapDRR(module);
  WrapContours(module);
  WrapCrowns(module);
}
} // namespace dentalscr
