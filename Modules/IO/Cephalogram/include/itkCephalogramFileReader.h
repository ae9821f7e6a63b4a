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
#ifndef itkCephalogramFileReader_h
#define itkCephalogramFileReader_h

#include "CephalogramExport.h"
#include "itkCephalometricGeometry.h"
#include "itkPixelSpacingVerdict.h"

#include "itkImage.h"
#include "itkImageSource.h"
#include "itkVector.h"

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace itk
{
class RadiographFile;

/** \class CephalogramFileReader
 * \brief Reads a cephalogram as a grey 2-D image and says what its pixel spacing is worth.
 *
 * PNG, JPEG, TIFF, BMP, NRRD, MetaImage, NIfTI and DICOM, recognised by what stands in the file; no ImageIO factory has
 * to be registered. Colour becomes luminance (Rec. 709), transparency black. DICOM's rescale is applied and MONOCHROME1
 * is inverted, so that dense is bright. A volume of one slice is a picture; several frames or pages are an error.
 *
 * Spacing: a verdict (PixelSpacingVerdictEnum) by the table of DecidePixelSpacing() for DICOM. A resolution in dots per
 * inch is never a spacing: PNG, JPEG, TIFF and BMP are Unknown. An explicit spacing of a NRRD or MetaImage counts as
 * the detector's, but for 1 and for 25.4/72 and 25.4/96, which stand for none. SetUserPixelSpacing() overrides all.
 * Unknown is never 1.0: GetPixelSpacing() throws, see HasPixelSpacing().
 *
 * The output's origin is 0 and its direction the identity, whatever the file says. Its own spacing is the verdict's, in
 * the verdict's plane, where there is one; where the verdict is Unknown it is 1, a pixel. The metadata dictionary has
 * the verdict and the plane under VerdictKey and PlaneKey, for what lies downstream.
 *
 * From DICOM further: source-to-detector distance, source-to-midsagittal distance = that / magnification factor where
 * both exist; facing, or of a frontal one where the patient's left and the source are. GetProvenance() says where each
 * value comes from; GetWarnings() what is odd. All of this is there after UpdateOutputInformation(), which reads no
 * pixel.
 *
 * Throws DentalInputError for a missing, empty or truncated file, a directory, what is no image, several frames, no
 * pixels or more than MaximumNumberOfPixels, MaximumWidthAndHeight or MaximumNumberOfBytes, and pixels that are not
 * finite.
 *
 * \ingroup Cephalogram
 */
class Cephalogram_EXPORT CephalogramFileReader : public ImageSource<Image<float, 2>>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(CephalogramFileReader);

  using Self = CephalogramFileReader;
  using Superclass = ImageSource<Image<float, 2>>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(CephalogramFileReader, ImageSource);

  using PixelSpacingType = Vector<double, 2>;
  using FacingEnum = CephalometricGeometry::FacingEnum;
  using PatientLeftEnum = CephalometricGeometry::PatientLeftEnum;
  using FrontalSourceEnum = CephalometricGeometry::FrontalSourceEnum;
  using DirectionEnum = CephalometricGeometry::DirectionEnum;
  /** Name of a value to its source in words. Names: "pixel_spacing", "source_to_detector", "source_to_midsagittal",
   * "facing", "patient_left", "direction", "distance_source_to_patient" (reported, never used), "photometric",
   * "orientation". A value that the file has not is not in it, but for "pixel_spacing". */
  using ProvenanceType = std::map<std::string, std::string>;

  /** A film of 8 x 10 inches has 115 million pixels at 1200 dots per inch. */
  static constexpr SizeValueType MaximumNumberOfPixels = SizeValueType{ 1 } << 27;
  static constexpr SizeValueType MaximumWidthAndHeight = SizeValueType{ 1 } << 15;
  /** Of the decoded pixels and the image together: grey values of 16 bits have it at MaximumNumberOfPixels. */
  static constexpr SizeValueType MaximumNumberOfBytes = SizeValueType{ 6 } << 27;
  static constexpr const char *  VerdictKey = "DentalSCR_PixelSpacingVerdict";
  static constexpr const char *  PlaneKey = "DentalSCR_PixelSpacingPlane";
  /** The picture to read: any format of FileFormats.md. Must be set. */
  itkSetStringMacro(FileName);
  itkGetStringMacro(FileName);

  /** mm a pixel, (u, v), which overrides the file's. Throws unless both are above 0 and the plane is known. */
  void
  SetUserPixelSpacing(const PixelSpacingType & spacing, SpacingPlaneEnum plane = SpacingPlaneEnum::Detector);
  void
  ClearUserPixelSpacing();

  /** \name After UpdateOutputInformation()
   * @{ */
  itkGetEnumMacro(PixelSpacingVerdict, PixelSpacingVerdictEnum);
  /** The plane in which GetPixelSpacing() holds. */
  itkGetEnumMacro(SpacingPlane, SpacingPlaneEnum);
  bool
  HasPixelSpacing() const
  {
    return m_PixelSpacing.has_value();
  }
  /** mm a pixel, (u, v), in the plane of GetSpacingPlane(). Throws where the verdict is Unknown. */
  PixelSpacingType
  GetPixelSpacing() const;
  /** The spacing in the detector plane, as CephalometricGeometry wants it: one that holds in the midsagittal plane is
   * multiplied by sourceToDetector / sourceToMidsagittal (mm, the geometry's). Of EstimatedMagnification it is the
   * file's imager pixel spacing, whatever the geometry is: undoing the file's factor by another one would make a
   * spacing that no detector has. Throws where the verdict is Unknown, or where it holds in the midsagittal plane and
   * the geometry does not magnify. */
  PixelSpacingType
  GetDetectorPixelSpacing(double sourceToDetector, double sourceToMidsagittal) const;

  /** Spacing and origin (mm) that other programs built on ITK, 3D Slicer for one, give the picture by its header: not
   * what they are worth, but what positions in millimetres on the picture were made with. Known of DICOM, NRRD and
   * MetaImage whose axes are those of the picture; the other formats are loaded in several ways. The getters throw
   * where there is none. */
  bool
  HasHeaderSpacing() const
  {
    return m_HeaderSpacing.has_value();
  }
  PixelSpacingType
  GetHeaderSpacing() const;
  PixelSpacingType
  GetHeaderOrigin() const;

  /** mm, (0018,1110). The getter throws where there is none. */
  bool
  HasSourceToDetectorDistance() const
  {
    return m_SourceToDetectorDistance.has_value();
  }
  double
  GetSourceToDetectorDistance() const;
  /** mm, (0018,1110) / (0018,1114). The getter throws where one of them is missing. */
  bool
  HasSourceToMidsagittalDistance() const
  {
    return m_SourceToMidsagittalDistance.has_value();
  }
  double
  GetSourceToMidsagittalDistance() const;
  /** (0018,1114). The getter throws where there is none. */
  bool
  HasMagnificationFactor() const
  {
    return m_MagnificationFactor.has_value();
  }
  double
  GetMagnificationFactor() const;
  /** From the patient orientation (0020,0020). The getter throws where it is missing or not that of a lateral
   * cephalogram. */
  bool
  HasFacing() const
  {
    return m_Facing.has_value();
  }
  FacingEnum
  GetFacing() const;

  /** Of a frontal radiograph: where the patient's left is, by DICOM's patient orientation. */
  bool
  HasPatientLeft() const
  {
    return m_PatientLeft.has_value();
  }
  PatientLeftEnum
  GetPatientLeft() const;

  /** Of a frontal radiograph: where the source stood, by DICOM's view position (PA or AP). */
  bool
  HasFrontalSource() const
  {
    return m_FrontalSource.has_value();
  }
  FrontalSourceEnum
  GetFrontalSource() const;

  /** From where the radiograph was taken, by DICOM's view position, else by its patient orientation. */
  bool
  HasRadiographDirection() const
  {
    return m_RadiographDirection.has_value();
  }
  DirectionEnum
  GetRadiographDirection() const;
  /** From which values of the file each part of the geometry came. */
  const ProvenanceType &
  GetProvenance() const
  {
    return m_Provenance;
  }
  /** Each "file: field: what". */
  const std::vector<std::string> &
  GetWarnings() const
  {
    return m_Warnings;
  }
  /** "PNG", "JPEG", "TIFF", "BMP", "NRRD", "MetaImage", "NIfTI" or "DICOM". */
  const std::string &
  GetFileFormat() const
  {
    return m_FileFormat;
  }
  /** @} */

protected:
  CephalogramFileReader() = default;
  ~CephalogramFileReader() override = default;

  void
  VerifyPreconditions() ITKv5_CONST override;
  void
  GenerateOutputInformation() override;
  void
  EnlargeOutputRequestedRegion(DataObject * output) override;
  void
  GenerateData() override;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  void
  ReadDicomTags();
  void
  ReadHeaderSpacing();
  void
  ReadHeaderGrid();
  std::optional<double>
  ReadPositiveTag(const char * key, const char * name);
  std::optional<std::array<double, 2>>
  ReadSpacingTag(const char * key, const char * name);
  std::string
  GetTag(const char * key) const;
  void
  Warn(const std::string & field, const std::string & text);

  std::string                     m_FileName;
  std::optional<PixelSpacingType> m_UserPixelSpacing;
  SpacingPlaneEnum                m_UserSpacingPlane{ SpacingPlaneEnum::Detector };

  /** Between GenerateOutputInformation() and GenerateData(). */
  std::shared_ptr<const RadiographFile> m_File;
  std::string                           m_FileFormat;
  PixelSpacingVerdictEnum               m_PixelSpacingVerdict{ PixelSpacingVerdictEnum::Unknown };
  SpacingPlaneEnum                      m_SpacingPlane{ SpacingPlaneEnum::Unknown };
  std::optional<PixelSpacingType>       m_PixelSpacing;
  /** Where it is known beside m_PixelSpacing. */
  std::optional<PixelSpacingType>  m_ImagerPixelSpacing;
  std::optional<PixelSpacingType>  m_HeaderSpacing;
  PixelSpacingType                 m_HeaderOrigin;
  std::optional<double>            m_SourceToDetectorDistance;
  std::optional<double>            m_SourceToMidsagittalDistance;
  std::optional<double>            m_MagnificationFactor;
  std::optional<FacingEnum>        m_Facing;
  std::optional<PatientLeftEnum>   m_PatientLeft;
  std::optional<FrontalSourceEnum> m_FrontalSource;
  std::optional<DirectionEnum>     m_RadiographDirection;
  ProvenanceType                   m_Provenance;
  std::vector<std::string>         m_Warnings;
};
} // namespace itk

#endif
