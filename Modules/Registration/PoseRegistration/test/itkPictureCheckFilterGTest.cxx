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

#include "itkDentalPhantomCaseSource.h"
#include "itkImageRegionIteratorWithIndex.h"

#include "itkGTest.h"

#include <functional>
#include <string>

namespace
{
using FilterType = itk::PictureCheckFilter;
using ImageType = FilterType::ImageType;
using Source = itk::DentalPhantomCaseSource;

/** A phantom's radiograph with what was drawn on it. */
Source *
Phantom()
{
  static const Source::Pointer source = [] {
    auto made = Source::New();
    made->SetSeed(3);
    made->SetNumberOfTriangles(20000);
    made->Update();
    return made;
  }();
  return source;
}

/** The radiograph, each pixel taken from where `from` says. */
ImageType::Pointer
MakePicture(const std::function<ImageType::IndexType(ImageType::IndexType, const ImageType::SizeType &)> & from)
{
  const auto * const radiograph = Phantom()->GetRadiograph();
  const auto         size = radiograph->GetBufferedRegion().GetSize();
  auto               picture = ImageType::New();
  picture->SetRegions(size);
  picture->Allocate();
  itk::ImageRegionIteratorWithIndex<ImageType> it(picture, picture->GetBufferedRegion());
  for (; !it.IsAtEnd(); ++it)
  {
    it.Set(static_cast<float>(radiograph->GetPixel(from(it.GetIndex(), size))));
  }
  return picture;
}

ImageType::Pointer
MakePicture()
{
  return MakePicture([](ImageType::IndexType index, const ImageType::SizeType &) { return index; });
}

FilterType::Pointer
MakeFilter(const ImageType * picture)
{
  auto filter = FilterType::New();
  filter->SetRadiograph(picture);
  filter->SetUpperContour(Phantom()->GetTracing(0));
  filter->SetLowerContour(Phantom()->GetTracing(1));
  filter->SetGeometry(Phantom()->GetNominalGeometry());
  return filter;
}

void
ExpectNotCheckable(FilterType * filter, const std::string & why)
{
  filter->Update();
  EXPECT_TRUE(filter->GetFindings().empty());
  ASSERT_EQ(filter->GetNotCheckable().size(), 1u);
  EXPECT_NE(filter->GetNotCheckable()[0].find(why), std::string::npos) << filter->GetNotCheckable()[0];
}
} // namespace

TEST(PictureCheckFilter, SaysNothingOfThePictureThatWasDrawnOn)
{
  const auto filter = MakeFilter(MakePicture());
  filter->Update();
  EXPECT_TRUE(filter->GetFindings().empty());
  EXPECT_TRUE(filter->GetNotCheckable().empty());
}

TEST(PictureCheckFilter, NamesWhatWasDoneToThePictureAfterwards)
{
  const auto mirrored = MakeFilter(MakePicture([](ImageType::IndexType index, const ImageType::SizeType & size) {
    index[0] = static_cast<itk::IndexValueType>(size[0]) - 1 - index[0];
    return index;
  }));
  mirrored->Update();
  ASSERT_EQ(mirrored->GetFindings().size(), 1u);
  const itk::RegistrationFinding & finding = mirrored->GetFindings()[0];
  EXPECT_EQ(finding.code, "picture");
  EXPECT_EQ(finding.severity, itk::RegistrationStatusEnum::Suspect);
  EXPECT_NE(finding.text.find("mirrored (left and right exchanged)"), std::string::npos) << finding.text;

  const auto turned = MakeFilter(MakePicture([](ImageType::IndexType index, const ImageType::SizeType & size) {
    for (unsigned int d = 0; d < 2; ++d)
    {
      index[d] = static_cast<itk::IndexValueType>(size[d]) - 1 - index[d];
    }
    return index;
  }));
  turned->Update();
  ASSERT_EQ(turned->GetFindings().size(), 1u);
  EXPECT_NE(turned->GetFindings()[0].text.find("turned by 180 degrees"), std::string::npos);
}

TEST(PictureCheckFilter, SaysWhereItCannotTell)
{
  ExpectNotCheckable(MakeFilter(nullptr), "there is no picture of it");
  ExpectNotCheckable(MakeFilter(MakePicture([](ImageType::IndexType index, const ImageType::SizeType &) {
                       index.Fill(0);
                       return index;
                     })),
                     "no edges under the drawing");
  const auto undrawn = MakeFilter(MakePicture());
  undrawn->SetUpperContour(nullptr);
  undrawn->SetLowerContour(itk::DentalContour::New());
  ExpectNotCheckable(undrawn, "landmarks lie on edges of any picture");
  const auto unknown = MakeFilter(MakePicture());
  unknown->SetGeometry(itk::CephalometricGeometry::New());
  ExpectNotCheckable(unknown, "pixel spacing");
}

TEST(PictureCheckFilter, RunsOnceAndAgainWithAnotherPicture)
{
  const auto   filter = MakeFilter(nullptr);
  unsigned int executions = 0;
  filter->AddObserver(itk::StartEvent(), [&](const itk::EventObject &) { ++executions; });
  filter->Update();
  filter->Update();
  EXPECT_EQ(executions, 1u);
  filter->SetRadiograph(MakePicture());
  filter->Update();
  EXPECT_EQ(executions, 2u);
  EXPECT_TRUE(filter->GetNotCheckable().empty()) << "what the run before could not tell is forgotten";
}

TEST(PictureCheckFilter, NamesTheCallThatIsMissing)
{
  auto filter = FilterType::New();
  try
  {
    filter->Update();
    FAIL();
  }
  catch (const itk::ExceptionObject & error)
  {
    EXPECT_NE(std::string(error.GetDescription()).find("SetGeometry()"), std::string::npos);
  }
}
