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
#ifndef itkSilhouetteContourFilter_h
#define itkSilhouetteContourFilter_h

#include "SilhouetteContourExport.h"
#include "itkDentalContour.h"
#include "itkImage.h"
#include "itkImageToMeshFilter.h"
#include "itkIsoContourTracer.h"

#include <limits>
#include <ostream>
#include <vector>

namespace itk
{
/** \class SilhouetteContourFilterEnums
 * \brief Enumerations of SilhouetteContourFilter.
 *
 * \ingroup SilhouetteContour
 */
class SilhouetteContourFilterEnums
{
public:
  /** What the pixels are. */
  enum class Content : uint8_t
  {
    /** A silhouette or thickness map, a DRR: the iso-contour at a level. */
    Intensity,
    /** FDI numbers, 0 the background: a contour with its tooth code for every label. */
    ToothLabels,
    /** Labels of any meaning: one contour around all that is not 0. */
    MergedLabels
  };
  /** How the level of Intensity is found. */
  enum class Level : uint8_t
  {
    /** LevelValue itself. */
    Absolute,
    /** LevelFraction of the way from the background to the other extreme. */
    Fraction,
    /** Half the median of what is not background. */
    Automatic
  };
  /** In what the contour is expressed. */
  enum class OutputCoordinates : uint8_t
  {
    Index,
    Physical,
    PhysicalOverSpacing
  };
};
SilhouetteContour_EXPORT std::ostream &
                         operator<<(std::ostream & os, SilhouetteContourFilterEnums::Content content);
SilhouetteContour_EXPORT std::ostream &
                         operator<<(std::ostream & os, SilhouetteContourFilterEnums::Level level);
SilhouetteContour_EXPORT std::ostream &
                         operator<<(std::ostream & os, SilhouetteContourFilterEnums::OutputCoordinates coordinates);

/** \class SilhouetteContourFilter
 * \brief The outer silhouette in an image at sub-pixel precision, or the outlines in a label map, as closed contours.
 *
 * Intensity: an iso-contour by marching squares with linear interpolation; see IsoContourTracer. The background is the
 * image's smallest value, or the largest with ObjectIsDarkOn() (I_0 exp(-mu L)). Level:
 *  - Absolute: LevelValue.
 *  - Fraction: background + LevelFraction (other extreme - background).
 *  - Automatic (the default): half-way between the background and the median of the object: of all pixels that
 *    differ from the background by more than 1 % of the range, and then of all above the level so found. The maximum of
 * a DRR lies where rays graze the surface and says little about the rest; the median does not depend on such places. On
 * a mask that has been smoothed with a Gaussian of width sigma the half level lies on a straight edge without bias, and
 * sigma^2 / (2 R) inside of an edge of radius R. A thickness map has no plateau: its contour is off by a share of sigma
 * that depends on the level and on what lies behind. Documentation/Contours.md has figures.
 *
 * ToothLabels, MergedLabels: the outline runs half-way between pixel centres, in steps; with LabelSmoothing it is the
 * half level of the label's mask under a Gaussian of that width: smooth, unbiased on a straight edge and sigma^2 / (2
 * R) inside of an edge of radius R. An integer pixel type or whole numbers are expected; a label that is no FDI number
 * is an error under ToothLabels.
 *
 * Output: closed polylines, largest area first (labels: in the order of their FDI numbers, largest part first), in the
 * sense that SilhouetteLoop defines. Holes are ignored. Objects that touch the border are closed around it, at most a
 * pixel outside. Coordinates:
 *  - Index: the image's continuous index; a start index that is not 0 counts. A DRR of SurfaceDRRImageSource with its
 *    defaults has the cephalogram's indices, also where it is larger.
 *  - Physical: physical space (mm).
 *  - PhysicalOverSpacing: physical space divided by the spacing: the index in an image of this spacing with origin 0
 * and identity direction. For a DRR with an origin of its own. and OutputOffset is subtracted from all of them; with
 * the principal point as offset the contour is in the q coordinates of a similarity.
 *
 * Streaming: with NumberOfStreamDivisions above 1 the image is pulled in so many strips of rows, one after the other,
 * and only one strip is held: a DRR of any size becomes a contour in the memory of a strip. The strips are pulled once
 * under Absolute, twice under Fraction and labels and three times under Automatic, which wants the range and the median
 * first. The contour has the same bits for any number of strips. Of labels, masks as large as their bounding boxes are
 * held.
 *
 * Errors: no input, pixels that are not finite. An image of one value gives an empty contour.
 *
 * Source: the paper's contour of the DRR.
 *
 * \ingroup SilhouetteContour
 */
template <typename TInputImage>
class ITK_TEMPLATE_EXPORT SilhouetteContourFilter : public ImageToMeshFilter<TInputImage, DentalContour>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(SilhouetteContourFilter);

  using Self = SilhouetteContourFilter;
  using Superclass = ImageToMeshFilter<TInputImage, DentalContour>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(SilhouetteContourFilter, ImageToMeshFilter);

  static_assert(TInputImage::ImageDimension == 2, "A silhouette has two dimensions.");

  using InputImageType = TInputImage;
  using ContentEnum = SilhouetteContourFilterEnums::Content;
  using LevelEnum = SilhouetteContourFilterEnums::Level;
  using OutputCoordinatesEnum = SilhouetteContourFilterEnums::OutputCoordinates;
  using OffsetType = Vector<double, 2>;

  /** Default Intensity. */
  itkSetEnumMacro(Content, ContentEnum);
  itkGetEnumMacro(Content, ContentEnum);

  /** Default Automatic. */
  itkSetEnumMacro(Level, LevelEnum);
  itkGetEnumMacro(Level, LevelEnum);

  /** The level under Absolute, in grey values. Default 0.5. */
  itkSetMacro(LevelValue, double);
  itkGetConstMacro(LevelValue, double);

  /** The level under Fraction, above 0 and below 1. Default 0.5. */
  itkSetMacro(LevelFraction, double);
  itkGetConstMacro(LevelFraction, double);

  /** The object is darker than the background. Default off. */
  itkSetMacro(ObjectIsDark, bool);
  itkGetConstMacro(ObjectIsDark, bool);
  itkBooleanMacro(ObjectIsDark);

  /** Only the part with the largest area, of each label under ToothLabels. Default on. */
  itkSetMacro(LargestPartOnly, bool);
  itkGetConstMacro(LargestPartOnly, bool);
  itkBooleanMacro(LargestPartOnly);

  /** Parts with a smaller area, square pixels, are left out. Default 0. */
  itkSetMacro(MinimumArea, double);
  itkGetConstMacro(MinimumArea, double);

  /** Width of the Gaussian under which labels are outlined, pixels, up to 100. Default 0: pixel edges. Parts thinner
   * than about the width vanish. */
  itkSetClampMacro(LabelSmoothing, double, 0.0, 100.0);
  itkGetConstMacro(LabelSmoothing, double);

  /** Default Index. */
  itkSetEnumMacro(OutputCoordinates, OutputCoordinatesEnum);
  itkGetEnumMacro(OutputCoordinates, OutputCoordinatesEnum);

  /** Subtracted from the output, in its unit. Default 0. */
  itkSetMacro(OutputOffset, OffsetType);
  itkGetConstReferenceMacro(OutputOffset, OffsetType);

  /** Strips in which the image is pulled; no more than it has rows. Default 1: the whole image at once. */
  itkSetClampMacro(NumberOfStreamDivisions, unsigned int, 1, std::numeric_limits<unsigned int>::max());
  itkGetConstMacro(NumberOfStreamDivisions, unsigned int);

  /** What lies upstream is asked for strips while this filter runs, so that nothing is asked for before. */
  void
  PropagateRequestedRegion(DataObject * output) override;
  void
  UpdateOutputData(DataObject * output) override;

  /** The level that was used, in grey values. Valid after Update(). */
  itkGetConstMacro(UsedLevel, double);

protected:
  SilhouetteContourFilter();
  ~SilhouetteContourFilter() override = default;

  void
  VerifyPreconditions() ITKv5_CONST override;

  void
  GenerateData() override;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  using RegionType = typename TInputImage::RegionType;

  /** All of the image. */
  RegionType
  GetWholeRegion();

  /** Brings one strip of rows after the other up to date and calls visit(region) for each, from the first row on.
   * \param first  progress at the beginning
   * \param share  progress that it makes */
  template <typename TVisit>
  void
  ForEachStrip(float first, float share, TVisit && visit);

  /** Calls visit(value, column, iterator) for every pixel in the order of rows; values have the sign under which the
   * object is bright. */
  template <typename TVisit>
  void
  ForEachValue(float first, float share, TVisit && visit);

  /** Half the median of the object, by a histogram. */
  double
  FindAutomaticLevel(double background, double extreme);

  void
  AddLoops(const std::vector<IsoContourTracer::LoopType> & loops, const RegionType & region, ToothCode code);

  void
  TraceIntensity();
  void
  TraceLabels();

  ContentEnum           m_Content{ ContentEnum::Intensity };
  LevelEnum             m_Level{ LevelEnum::Automatic };
  double                m_LevelValue{ 0.5 };
  double                m_LevelFraction{ 0.5 };
  bool                  m_ObjectIsDark{ false };
  bool                  m_LargestPartOnly{ true };
  double                m_MinimumArea{ 0.0 };
  double                m_LabelSmoothing{ 0.0 };
  OutputCoordinatesEnum m_OutputCoordinates{ OutputCoordinatesEnum::Index };
  OffsetType            m_OutputOffset;
  unsigned int          m_NumberOfStreamDivisions{ 1 };
  double                m_UsedLevel{ 0.0 };
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkSilhouetteContourFilter.hxx"
#endif

namespace itk
{
extern template class SilhouetteContourFilter<Image<float, 2>>;
extern template class SilhouetteContourFilter<Image<double, 2>>;
extern template class SilhouetteContourFilter<Image<unsigned char, 2>>;
extern template class SilhouetteContourFilter<Image<unsigned short, 2>>;
extern template class SilhouetteContourFilter<Image<short, 2>>;
} // namespace itk

#endif
