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
#ifndef itkRegistrationOverlayFilter_h
#define itkRegistrationOverlayFilter_h

#include "RegistrationReportExport.h"
#include "itkDentalContour.h"
#include "itkDentalLandmarkSet.h"
#include "itkOverlayPainter.h"

#include "itkImage.h"
#include "itkImageSource.h"
#include "itkRGBPixel.h"
#include "itkVector.h"

#include <map>
#include <string>
#include <vector>

namespace itk
{
/** \class RegistrationOverlayFilter
 * \brief The picture by which a human judges a registration: radiograph, tracing, aligned contours of the scan,
 * landmarks, errors.
 *
 * Tracing and reference landmarks, that is what belongs to the radiograph, are blue, what comes from the scan is
 * orange, errors are yellow: told apart with any colour vision. The view is cropped to tracing and landmarks and
 * magnified; a small picture beside it shows the whole radiograph. Where predicted and reference landmarks are given
 * each error is printed, in px and, with a pixel spacing, in mm of the detector plane.
 *
 * All inputs are optional and all coordinates continuous pixel indices of the radiograph. Inputs: radiograph (grey;
 * read as floats and windowed), fixed contour, any number of moving contours, predicted and reference landmarks.
 * Output: one RGB image of PictureSize; the whole of it is made, whatever region is asked for. Needs no screen. The
 * fonts are DejaVu Sans. Write the output with WritePicture().
 *
 * Errors: a picture below 320 x 240 or above 16384 pixels, a radiograph above 32767 pixels a side.
 *
 * \ingroup RegistrationReport
 */
class RegistrationReport_EXPORT RegistrationOverlayFilter : public ImageSource<Image<RGBPixel<unsigned char>, 2>>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(RegistrationOverlayFilter);

  using Self = RegistrationOverlayFilter;
  using Superclass = ImageSource<Image<RGBPixel<unsigned char>, 2>>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(RegistrationOverlayFilter, ImageSource);

  using PictureType = Image<RGBPixel<unsigned char>, 2>;
  using RadiographType = Image<float, 2>;
  using LandmarkSetType = DentalLandmarkSet<2>;
  using PictureSizeType = PictureType::SizeType;
  using SpacingType = Vector<double, 2>;

  /** Shown as it is: white bright. Its own spacing, origin and direction play no part. */
  itkSetInputMacro(Radiograph, RadiographType);
  itkGetInputMacro(Radiograph, RadiographType);

  /** The tracing. */
  itkSetInputMacro(FixedContour, DentalContour);
  itkGetInputMacro(FixedContour, DentalContour);

  /** Aligned contours of the scan, numbered from 0. Number 0 is drawn bold (what was matched), others thin (the whole
   * silhouette). The label goes to the legend; null removes. */
  void
  SetMovingContour(unsigned int number, const DentalContour * contour, const std::string & label = std::string());
  void
  SetMovingContour(const DentalContour * contour)
  {
    this->SetMovingContour(0, contour);
  }
  const DentalContour *
  GetMovingContour(unsigned int number = 0) const;
  unsigned int
  GetNumberOfMovingContours() const
  {
    return static_cast<unsigned int>(m_MovingLabels.size());
  }

  /** The scan's landmarks in the radiograph, as the registration has them. */
  itkSetInputMacro(PredictedLandmarks, LandmarkSetType);
  itkGetInputMacro(PredictedLandmarks, LandmarkSetType);

  /** The landmarks' true places, if known. */
  itkSetInputMacro(ReferenceLandmarks, LandmarkSetType);
  itkGetInputMacro(ReferenceLandmarks, LandmarkSetType);

  /** Standard deviation an axis of predicted landmarks by name, pixels: drawn as the 95 % region. */
  void
  SetLandmarkSigmas(const std::map<std::string, double> & sigmas);
  const std::map<std::string, double> &
  GetLandmarkSigmas() const
  {
    return m_LandmarkSigmas;
  }

  /** mm a pixel in the detector plane; 0 (the default): unknown, lengths are in pixels then. */
  itkSetMacro(PixelSpacing, SpacingType);
  itkGetConstReferenceMacro(PixelSpacing, SpacingType);

  /** Width and height of the radiograph, for the frame where there is none to show. */
  void
  SetRadiographSize(unsigned int width, unsigned int height);
  itkGetConstReferenceMacro(RadiographSize, PictureSizeType);

  /** Grey values shown as black and white. Both 0 (the default): the 0.2 and 99.8 % quantiles. */
  void
  SetWindow(double black, double white);
  itkGetConstMacro(WindowBlack, double);
  itkGetConstMacro(WindowWhite, double);

  /** Of the output, pixels. Default 1400 x 900. */
  void
  SetPictureSize(unsigned int width, unsigned int height);
  itkGetConstReferenceMacro(PictureSize, PictureSizeType);
  /** First line of the picture's words; "" by default. */
  itkSetStringMacro(Title);
  itkGetStringMacro(Title);

  /** "ok", "suspect", "failed" or any word; empty (the default) shows none. */
  itkSetStringMacro(Status);
  itkGetStringMacro(Status);

  /** Lines beside the radiograph; long ones are wrapped. */
  void
  SetTextLines(const std::vector<std::string> & lines);
  const std::vector<std::string> &
  GetTextLines() const
  {
    return m_TextLines;
  }

  /** Part of the radiograph to show: its first and last pixel index of u, then of v; more is shown where the picture's
   * proportions differ. */
  void
  SetView(double firstU, double lastU, double firstV, double lastV);
  /** Show tracing and landmarks (the default). */
  void
  SetViewToContours();

  /** Free border around tracing and landmarks, as a part of their larger extent. Default 0.2. */
  itkSetMacro(Margin, double);
  itkGetConstMacro(Margin, double);

  /** Where the last update put the radiograph in the picture. */
  const OverlayLayout &
  GetLayout() const
  {
    return m_Layout;
  }

protected:
  RegistrationOverlayFilter();
  ~RegistrationOverlayFilter() override = default;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;
  void
  GenerateOutputInformation() override;
  void
  EnlargeOutputRequestedRegion(DataObject * output) override;
  void
  GenerateData() override;

private:
  OverlayScene
  MakeScene() const;

  std::vector<std::string>      m_MovingLabels;
  std::map<std::string, double> m_LandmarkSigmas;
  SpacingType                   m_PixelSpacing;
  PictureSizeType               m_RadiographSize;
  double                        m_WindowBlack{ 0.0 };
  double                        m_WindowWhite{ 0.0 };
  PictureSizeType               m_PictureSize;
  std::string                   m_Title;
  std::string                   m_Status;
  std::vector<std::string>      m_TextLines;
  std::array<double, 4>         m_View{ 0.0, 0.0, 0.0, 0.0 };
  double                        m_Margin{ 0.2 };
  OverlayLayout                 m_Layout;
};
} // namespace itk

#endif
