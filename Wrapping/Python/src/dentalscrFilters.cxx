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

py::array_t<double>
ToArray(const std::array<double, 3> & values)
{
  return MakeArray<double>(std::vector<double>(values.begin(), values.end()));
}

py::dict
PlaneToDict(const itk::MidsagittalPlaneResult & plane)
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
    .def("SetJawsShareFrame",
         &AxisType::SetJawsShareFrame,
         py::arg("mode"),
         "Sets whether both scans lie in one frame, in occlusion. Check, the default, looks at "
         "contact, heights and directions of the arches.")
    .def("GetJawsShareFrame",
         &AxisType::GetJawsShareFrame,
         "Returns whether both scans lie in one frame, in occlusion. Check, the default, looks at "
         "contact, heights and directions of the arches.")
    .dentalscrProperty(AxisType,
                       CrownFraction,
                       "the share of the surface that is taken for crowns, in (0, 1]; 0.15 by default, the paper's "
                       "p.")
    .dentalscrProperty(AxisType,
                       MaximumIterations,
                       "the most rounds of crown candidates, principal axes and occlusal direction; 20 by default. "
                       "It stops when the direction does.")
    .dentalscrBoolean(
      AxisType, RefineMidline, "whether the midline plane is moved to the scan's mirror plane. Off by default.")
    .dentalscrBoolean(
      AxisType, EmbedAxes, "whether arrows along the axes are added to the output meshes. Off by default.")
    .dentalscrProperty(AxisType, AxesLength, "the length of the arrow along x, mm; 40 by default.")
    .dentalscrBoolean(AxisType,
                      TransformMeshes,
                      "whether the output meshes are made. On by default; off for those who want the frames alone.")
    .dentalscrBoolean(AxisType,
                      RequireArches,
                      "whether a mesh without an arch is an error. On by default; off, its outputs are empty and "
                      "the other jaw is none the worse.")
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
      [](const AxisType & self, JawEnum jaw) { return self.GetBaselineRight(jaw); },
      py::arg("jaw"),
      "End of the molar baseline on the patient's right, mesh frame, mm.")
    .def(
      "GetBaselineLeft",
      [](const AxisType & self, JawEnum jaw) { return self.GetBaselineLeft(jaw); },
      py::arg("jaw"),
      "Left end of the molar baseline, mm, in the mesh's frame.")
    .def(
      "GetBaselineMidpoint",
      [](const AxisType & self, JawEnum jaw) { return self.GetBaselineMidpoint(jaw); },
      py::arg("jaw"),
      "Middle of the molar baseline, mm, in the mesh's frame.")
    .def(
      "GetIncisalEdge",
      [](const AxisType & self, JawEnum jaw) { return self.GetIncisalEdge(jaw); },
      py::arg("jaw"),
      "Middle of the incisal edge, mm, in the mesh's frame.")
    .def(
      "GetArchWidth", [](const AxisType & self, JawEnum jaw) { return self.GetArchWidth(jaw); }, py::arg("jaw"), "mm.")
    .def(
      "GetArchDepth", [](const AxisType & self, JawEnum jaw) { return self.GetArchDepth(jaw); }, py::arg("jaw"), "mm.")
    .def(
      "GetConfidence",
      [](const AxisType & self, JawEnum jaw) { return self.GetConfidence(jaw); },
      py::arg("jaw"),
      "In [0, 1]; below 0.5 a person should look at the axes.")
    .def("GetJawsAreInOneFrame",
         &AxisType::GetJawsAreInOneFrame,
         "Whether the jaws were treated as in one frame. Overjet and overbite mean something only "
         "then.")
    .def("GetOverjet", &AxisType::GetOverjet, "mm; means something only where the jaws are in one frame.")
    .def("GetOverbite", &AxisType::GetOverbite, "mm; means something only where the jaws are in one frame.");

  ProcessClass<PlaneFilterType>(module, "MidsagittalPlaneFilter", "The mirror plane of one arch or of a pair.")
    .def(New<PlaneFilterType>())
    .def("_SetUpperMesh", &PlaneFilterType::SetUpperMesh, py::arg("mesh"))
    .def("_SetLowerMesh", &PlaneFilterType::SetLowerMesh, py::arg("mesh"))
    .def("_GetPlane", [](const PlaneFilterType & self) { return PlaneToDict(self.GetPlaneOutput()->Get()); })
    .def(
      "GetNormal", &PlaneFilterType::GetNormal, "Unit normal of the plane that was found, in the frame of the meshes.")
    .def("GetOffset", &PlaneFilterType::GetOffset, "Distance of the plane from the origin along its normal, mm.")
    .def("SignedDistance",
         &PlaneFilterType::SignedDistance,
         py::arg("point"),
         "Distance of a point (mm, in the frame of the meshes) from the plane, positive on the side "
         "of the normal.");
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
    .dentalscrProperty(DRRType,
                       Sigma,
                       "the width of the splats, mm in the detector plane, of every mesh without one of its own; "
                       "0.5 by default.")
    .def("SetMeshSigma",
         &DRRType::SetMeshSigma,
         py::arg("number"),
         py::arg("sigma"),
         "Sets the width of the splats of one mesh by its number, mm in the detector plane; 0 returns "
         "to Sigma.")
    .def("GetMeshSigma",
         &DRRType::GetMeshSigma,
         py::arg("number"),
         "Width of the splats of one mesh by its number, mm in the detector plane; 0 stands for Sigma.")
    .def("SetVertexSigmas",
         &DRRType::SetVertexSigmas,
         py::arg("number"),
         py::arg("sigmas"),
         "Sets the widths of the splats of one mesh, one a vertex in the order of the points, mm; an "
         "empty list returns to one width.")
    .def("GetVertexSigmas",
         &DRRType::GetVertexSigmas,
         py::arg("number"),
         "Widths of the splats of one mesh, one a vertex, mm; empty where it has one width.")
    .def("SetNormalization",
         &DRRType::SetNormalization,
         py::arg("normalization"),
         "Sets how the sum of the splats becomes a thickness: Physical (the default, mm) or Paper.")
    .def("GetNormalization",
         &DRRType::GetNormalization,
         "Returns how the sum of the splats becomes a thickness: Physical (the default, mm) or Paper.")
    .def("SetOutputMode", &DRRType::SetOutputMode, py::arg("mode"), "Sets what the pixels hold; Thickness by default.")
    .def("GetOutputMode", &DRRType::GetOutputMode, "Returns what the pixels hold; Thickness by default.")
    .dentalscrProperty(
      DRRType, Density, "the thickness of the shell, mm, under Physical, and a factor under Paper; 1 by default.")
    .dentalscrProperty(DRRType, SourceIntensity, "the intensity without anything in the beam; 1 by default.")
    .dentalscrProperty(DRRType,
                       Attenuation,
                       "the attenuation coefficient, 1/mm under Physical; 0.08 by default, that of enamel at about "
                       "60 keV.")
    .dentalscrProperty(DRRType,
                       Tolerance,
                       "the largest error relative to the maximum on the detector plane, in [1e-6, 0.1]; 1e-3 by "
                       "default.")
    .dentalscrBoolean(DRRType, UseGeometrySpacing, "whether the pixel spacing is that of the geometry. On by default.")
    .def(
      "SetSize",
      [](DRRType & self, const itk::Size<2> & size) { self.SetSize(size); },
      py::arg("size"),
      "Sets the size of the output region (width, height), pixels. To set it turns CoverMeshes off.")
    .def(
      "GetSize",
      [](const DRRType & self) { return self.GetSize(); },
      "Returns the size of the output region (width, height), pixels. To set it turns CoverMeshes "
      "off.")
    .def(
      "SetStartIndex",
      [](DRRType & self, const itk::Index<2> & index) { self.SetStartIndex(index); },
      py::arg("index"),
      "Sets the first pixel of the output region, (u, v), which may be negative.")
    .def(
      "GetStartIndex",
      [](const DRRType & self) { return self.GetStartIndex(); },
      "Returns the first pixel of the output region, (u, v), which may be negative.")
    .def(
      "SetSpacing",
      [](DRRType & self, const itk::Vector<double, 2> & spacing) { self.SetSpacing(spacing); },
      py::arg("spacing"),
      "Sets the distance between pixels (u, v), mm in the detector plane, where UseGeometrySpacing "
      "is off.")
    .def(
      "GetSpacing",
      [](const DRRType & self) { return itk::Vector<double, 2>(self.GetSpacing()); },
      "Returns the distance between pixels (u, v), mm in the detector plane, where "
      "UseGeometrySpacing is off.")
    .def(
      "SetOrigin",
      [](DRRType & self, const itk::Point<double, 2> & origin) { self.SetOrigin(origin); },
      py::arg("origin"),
      "Sets the physical point of the pixel with index (0, 0), mm in the detector plane.")
    .def(
      "GetOrigin",
      [](const DRRType & self) { return self.GetOrigin(); },
      "Returns the physical point of the pixel with index (0, 0), mm in the detector plane.")
    .def(
      "_SetReferenceImage",
      [](DRRType & self, const ImageType * image) {
        self.SetReferenceImage(image);
        self.SetUseReferenceImage(image != nullptr);
      },
      py::arg("image"))
    .dentalscrBoolean(DRRType,
                      CoverMeshes,
                      "whether the region holds every projected vertex and a margin. On by default; SetSize() "
                      "turns it off.")
    .dentalscrProperty(DRRType,
                       CoverMargin,
                       "the margin of CoverMeshes, mm in the detector plane. A negative one, the default, stands "
                       "for four times the largest sigma.")
    .def("SetSizeToCoverMeshes",
         &DRRType::SetSizeToCoverMeshes,
         py::arg("margin"),
         "Turns CoverMeshes on and sets its margin, mm in the detector plane.")
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
    .def("SetContent",
         &SilhouetteType::SetContent,
         py::arg("content"),
         "Sets what the pixels are: grey values (Intensity, the default), FDI numbers (ToothLabels), or "
         "labels of any meaning (MergedLabels).")
    .def("GetContent",
         &SilhouetteType::GetContent,
         "Returns what the pixels are: grey values (Intensity, the default), FDI numbers (ToothLabels), or "
         "labels of any meaning (MergedLabels).")
    .def("SetLevel",
         &SilhouetteType::SetLevel,
         py::arg("level"),
         "Sets how the level of the contour is chosen; Automatic by default.")
    .def("GetLevel", &SilhouetteType::GetLevel, "Returns how the level of the contour is chosen; Automatic by default.")
    .dentalscrProperty(SilhouetteType, LevelValue, "the level under Absolute, in grey values; 0.5 by default.")
    .dentalscrProperty(SilhouetteType,
                       LevelFraction,
                       "the level under Fraction, between the darkest and the brightest pixel, above 0 and below 1; "
                       "0.5 by default.")
    .dentalscrBoolean(SilhouetteType, ObjectIsDark, "whether the object is darker than the background. Off by default.")
    .dentalscrBoolean(SilhouetteType,
                      LargestPartOnly,
                      "whether only the part with the largest area is kept, of each label under ToothLabels. On by "
                      "default.")
    .dentalscrProperty(
      SilhouetteType, MinimumArea, "the area below which parts are left out, square pixels; 0 by default.")
    .dentalscrProperty(SilhouetteType,
                       NumberOfStreamDivisions,
                       "the number of strips in which the image is pulled; 1 by default, the whole image at once.")
    .dentalscrProperty(SilhouetteType,
                       LabelSmoothing,
                       "the width of the Gaussian under which labels are outlined, pixels, up to 100; 0 by default: "
                       "the edges of pixels.")
    .def("SetOutputCoordinates",
         &SilhouetteType::SetOutputCoordinates,
         py::arg("coordinates"),
         "Sets whether the points come out as continuous pixel indices (Index, the default) or as "
         "physical points.")
    .def("GetOutputCoordinates",
         &SilhouetteType::GetOutputCoordinates,
         "Returns whether the points come out as continuous pixel indices (Index, the default) or as "
         "physical points.")
    .def("SetOutputOffset",
         &SilhouetteType::SetOutputOffset,
         py::arg("offset"),
         "Sets what is subtracted from every point of the output, (u, v) in its unit; 0 by default.")
    .def(
      "GetOutputOffset",
      [](const SilhouetteType & self) { return self.GetOutputOffset(); },
      "Returns what is subtracted from every point of the output, (u, v) in its unit; 0 by default.")
    .def("GetUsedLevel", &SilhouetteType::GetUsedLevel, "Of the last Execute().")
    .def("_TakeOutput", [](SilhouetteType & self) { return Detach(self.GetOutput()); });

  ProcessClass<MeshSilhouetteType>(module, "MeshSilhouetteContourSource", "The exact outer silhouette of a mesh.")
    .def(New<MeshSilhouetteType>())
    .def(
      "_SetInput", [](MeshSilhouetteType & self, const MeshType * mesh) { self.SetInput(mesh); }, py::arg("mesh"))
    .def("_SetGeometry", &MeshSilhouetteType::SetGeometry, py::arg("geometry"))
    .dentalscrBoolean(MeshSilhouetteType,
                      LargestPartOnly,
                      "whether only the part with the largest area is given. On by default; off, all parts that do "
                      "not hide in another.")
    .dentalscrBoolean(MeshSilhouetteType,
                      UseLabels,
                      "whether the mesh's point data are FDI numbers of teeth, so that the output's points know their "
                      "tooth. Off by default.")
    .dentalscrProperty(MeshSilhouetteType,
                       NumberOfPoints,
                       "the number of points of the output, at equal distances; 0, the default, gives the corners "
                       "of the silhouette.")
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
    .def("SetJaw",
         &OpenType::SetJaw,
         py::arg("jaw"),
         "Sets the jaw of the mesh, which says which way is occlusal: Upper (the default) or Lower.")
    .def("GetJaw",
         &OpenType::GetJaw,
         "Returns the jaw of the mesh, which says which way is occlusal: Upper (the default) or Lower.")
    .dentalscrBoolean(OpenType,
                      UseLabels,
                      "whether the mesh's point data are FDI numbers of teeth, so that the output's points know their "
                      "tooth. Off by default.")
    .dentalscrProperty(
      OpenType, Spacing, "the distance between points of the output, mm in the detector plane; 0.125 by default.")
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
    .def("SetMinimumNumberOfPoints",
         &MaskFilterType::SetMinimumNumberOfPoints,
         py::arg("number"),
         "Sets the number of points below which a stretch is left out; 2 by default.")
    .def("GetMinimumNumberOfPoints",
         &MaskFilterType::GetMinimumNumberOfPoints,
         "Returns the number of points below which a stretch is left out; 2 by default.")
    .def("_TakeOutput", [](MaskFilterType & self) { return Detach(self.GetOutput()); });

  ProcessClass<ResampleType>(module, "ContourResampleFilter", "Points at equal distances along a contour.")
    .def(New<ResampleType>())
    .def(
      "_SetInput",
      [](ResampleType & self, const itk::DentalContour * contour) { self.SetInput(contour); },
      py::arg("contour"))
    .dentalscrProperty(
      ResampleType, NumberOfPoints, "the number of points in total; 0, the default, goes by the spacing.")
    .dentalscrProperty(
      ResampleType, Spacing, "the distance between points, pixels, where the number of points is 0; 1 by default.")
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
      "SetJaw",
      [](CrownType & self, JawEnum jaw) { self.SetJaw(jaw); },
      py::arg("jaw"),
      "Sets the jaw of the mesh; Upper by default.")
    .def(
      "GetJaw", [](const CrownType & self) { return self.GetJaw(); }, "Returns the jaw of the mesh; Upper by default.")
    .dentalscrBoolean(
      CrownType, UseLabels, "whether tooth labels of the mesh, where it has any, say what is crown. On by default.")
    .def("SetLabelNumbering",
         &CrownType::SetLabelNumbering,
         py::arg("numbering"),
         "Sets how the labels number teeth: FDI (the default) or Universal.")
    .def("GetLabelNumbering",
         &CrownType::GetLabelNumbering,
         "Returns how the labels number teeth: FDI (the default) or Universal.")
    .dentalscrBoolean(CrownType,
                      KeepWholeMesh,
                      "whether the whole mesh comes out, with what is crown as its point data. Off by default.")
    .dentalscrProperty(CrownType,
                       MinimumCrownHeight,
                       "the least depth below the occlusal surface at which the gingival margin is looked for, mm; "
                       "2.5 by default.")
    .dentalscrProperty(CrownType,
                       MaximumCrownHeight,
                       "the greatest depth below the occlusal surface at which the gingival margin is looked for, "
                       "mm; 12.5 by default.")
    .def(
      "GetPointMask", [](const CrownType & self) { return MakeArray(self.GetPointMask()); }, "(N,) of 0 and 1.")
    .def(
      "GetTriangleMask", [](const CrownType & self) { return MakeArray(self.GetTriangleMask()); }, "(M,) of 0 and 1.")
    .def("GetCrownArea", &CrownType::GetCrownArea, "mm^2.")
    .def("GetMeanCrownHeight", &CrownType::GetMeanCrownHeight, "mm.")
    .def("GetMarginAngle", &CrownType::GetMarginAngle, "rad.")
    .def("GetLabelsWereUsed", &CrownType::GetLabelsWereUsed, "Whether the last run took the labels.")
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
    .def("SetSide", &SideType::SetSide, py::arg("side"), "Sets the patient's side that is kept; Right by default.")
    .def("GetSide", &SideType::GetSide, "Returns the patient's side that is kept; Right by default.")
    .dentalscrProperty(SideType,
                       Margin,
                       "how far beyond the midline plane the mesh is kept, mm; -0.5 by default, so that the other "
                       "side's incisor is not the outline.")
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
