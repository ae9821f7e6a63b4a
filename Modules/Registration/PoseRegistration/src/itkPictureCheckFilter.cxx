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
#include "itkPictureCheckFilter.h"

#include "itkDrawingOnPicture.h"

#include <cmath>
#include <sstream>

namespace itk
{
namespace
{
std::string
DescribeReading(PictureReadingEnum reading)
{
  switch (reading)
  {
    case PictureReadingEnum::Turned90:
      return "turned by 90 degrees clockwise";
    case PictureReadingEnum::Turned180:
      return "turned by 180 degrees";
    case PictureReadingEnum::Turned270:
      return "turned by 270 degrees clockwise";
    case PictureReadingEnum::Mirrored:
      return "mirrored (left and right exchanged)";
    default:
      return "mirrored (above and below exchanged)";
  }
}

/** What is to be done about a drawing that lies on edges elsewhere, or in another reading. */
std::string
DescribeDrawing(const DrawingOnPicture & found)
{
  std::ostringstream text;
  if (found.reading != PictureReadingEnum::Shifted)
  {
    text << "the radiograph seems to have been " << DescribeReading(found.reading)
         << " after it was drawn on: what was drawn lies on edges of its picture then, and on none as it is; give the "
            "picture that was drawn on";
    return text.str();
  }
  const auto say = [&](double pixels, const char * above, const char * below) {
    text << std::lround(std::abs(pixels)) << " px " << (pixels > 0.0 ? above : below);
  };
  text << "what was drawn lies on no edges of the radiograph where it is, and on edges of it ";
  say(found.shift[0], "to the right", "to the left");
  text << " and ";
  say(found.shift[1], "below", "above");
  text << ": was it drawn on another patient's radiograph, or on one that was cut otherwise? Give the picture that was "
          "drawn on";
  return text.str();
}
} // namespace

PictureCheckFilter::PictureCheckFilter()
{
  this->ProcessObject::RemoveRequiredInputName("Primary");
  this->AddRequiredInputName("Geometry");
  this->SetNumberOfRequiredOutputs(1);
  this->SetNthOutput(0, this->MakeOutput(0));
}

PictureCheckFilter::DataObjectPointer
PictureCheckFilter::MakeOutput(DataObjectPointerArraySizeType)
{
  return DecoratedFindingsType::New().GetPointer();
}

PictureCheckFilter::DecoratedFindingsType *
PictureCheckFilter::GetFindingsOutput()
{
  return dynamic_cast<DecoratedFindingsType *>(this->ProcessObject::GetOutput(0));
}

const PictureCheckFilter::FindingsType &
PictureCheckFilter::GetFindings()
{
  return this->GetFindingsOutput()->Get();
}

void
PictureCheckFilter::VerifyPreconditions() ITKv5_CONST
{
  if (this->GetGeometry() == nullptr)
  {
    itkExceptionMacro("There is no geometry, whose pixel spacing says how wide an edge of the picture is. Call "
                      "SetGeometry().");
  }
  Superclass::VerifyPreconditions();
}

void
PictureCheckFilter::GenerateData()
{
  m_NotCheckable.clear();
  FindingsType findings;
  const auto   isDrawnIn = [](const DentalContour * contour) {
    return contour != nullptr && contour->GetNumberOfPoints() > 0;
  };
  const bool        isDrawn = isDrawnIn(this->GetUpperContour()) || isDrawnIn(this->GetLowerContour());
  const auto        spacing = this->GetGeometry()->GetPixelSpacing();
  const std::string question = "whether the radiograph is the one that was drawn on: ";
  if (this->GetRadiograph() == nullptr || !isDrawn)
  {
    m_NotCheckable.push_back(question +
                             (isDrawn ? "there is no picture of it" : "a few landmarks lie on edges of any picture"));
  }
  else if (!(spacing[0] > 0.0 && spacing[1] > 0.0))
  {
    m_NotCheckable.push_back(question + "the pixel spacing, and with it the width of an edge, is unknown");
  }
  else
  {
    const DrawingOnPicture found = CompareDrawingWithPicture(
      this->GetRadiograph(), { this->GetUpperContour(), this->GetLowerContour() }, { { spacing[0], spacing[1] } });
    if (found.reading == PictureReadingEnum::Untold)
    {
      m_NotCheckable.push_back(question + "its grey values have no edges under the drawing");
    }
    else if (found.reading != PictureReadingEnum::AsItIs)
    {
      findings.push_back(
        { RegistrationStatusEnum::Suspect, "picture", DescribeDrawing(found), found.inReading, found.asItIs, "sd" });
    }
  }
  this->GetFindingsOutput()->Set(findings);
}

void
PictureCheckFilter::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "NotCheckable: " << m_NotCheckable.size() << std::endl;
}
} // namespace itk
