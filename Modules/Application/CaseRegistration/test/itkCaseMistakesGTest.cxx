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
// Mistakes that people make, and what the result says of them.
#include "itkCaseRegistrationTestCase.h"

#include <gtest/gtest.h>

#include <ostream>
#include <utility>

namespace
{
using JawEnum = itk::ToothCode::JawEnum;
constexpr JawEnum Jaws[] = { JawEnum::Upper, JawEnum::Lower };

struct Mistake
{
  const char * name;
  void (*make)(itk::DentalCaseData &);
  /** In a reason. */
  const char * word;
};

void
PrintTo(const Mistake & mistake, std::ostream * os)
{
  *os << mistake.name;
}

template <typename TFunction>
void
MovePoints(itk::DentalCaseData & data, TFunction && move)
{
  for (const JawEnum jaw : Jaws)
  {
    auto * points = data.GetJaw(jaw).mesh->GetPoints();
    for (auto it = points->Begin(); it != points->End(); ++it)
    {
      move(it.Value());
    }
  }
}

void
ExchangeJaws(itk::DentalCaseData & data)
{
  std::swap(data.upper.mesh, data.lower.mesh);
}

/** A file in mm that the case says is in cm. */
void
SayCentimetres(itk::DentalCaseData & data)
{
  data.description.meshUnit = "cm";
  data.description.millimetresPerUnit = 10.0;
  MovePoints(data, [](auto & point) {
    for (unsigned int d = 0; d < 3; ++d)
    {
      point[d] *= 10.0F;
    }
  });
}

void
FaceLeft(itk::DentalCaseData & data)
{
  data.geometry->SetFacing(itk::CephalometricGeometry::FacingEnum::Left);
}

void
SayLeft(itk::DentalCaseData & data)
{
  data.description.tracedSide = itk::TracedSideEnum::Left;
}

void
Mirror(itk::DentalCaseData & data)
{
  MovePoints(data, [](auto & point) { point[0] = -point[0]; });
}

void
StretchSpacing(itk::DentalCaseData & data)
{
  data.geometry->SetPixelSpacing(data.geometry->GetPixelSpacing() * 1.3);
}

void
KeepIncisors(itk::DentalCaseData & data)
{
  for (const JawEnum jaw : Jaws)
  {
    auto incisors = itk::DentalContour::New();
    for (const auto & polyline : data.GetJaw(jaw).contour->GetPolylines())
    {
      if (polyline.code.GetFDI() % 10 <= 2)
      {
        incisors->AddPolyline(polyline);
      }
    }
    data.GetJaw(jaw).contour = incisors;
  }
}

class CaseMistakes : public ::testing::TestWithParam<Mistake>
{};

struct Side
{
  const char *          name;
  PhantomCase::SideEnum phantom;
  itk::TracedSideEnum   said;
};

void
PrintTo(const Side & side, std::ostream * os)
{
  *os << side.name;
}

class CaseTracedSide : public ::testing::TestWithParam<Side>
{};
} // namespace

TEST_P(CaseMistakes, IsNamedInTheReasons)
{
  const PhantomCase phantom(6, PhantomCase::SideEnum::Right, 16000);
  GetParam().make(*phantom.data);
  const auto  result = Register(phantom);
  bool        named = false;
  std::string all;
  for (const auto & jaw : result.jaws)
  {
    EXPECT_NE(jaw.second.status, itk::RegistrationStatusEnum::Ok) << jaw.first;
    named = named || HasLineWith(jaw.second.GetReasons(), GetParam().word);
    for (const std::string & reason : jaw.second.GetReasons())
    {
      all += "\n  " + reason;
    }
  }
  EXPECT_TRUE(named) << "no \"" << GetParam().word << "\" in" << all;
}

/** A molar's marks all on the molar behind it, of one side alone, are in order along the arch: the tracing has the
 * tooth elsewhere. */
TEST(CaseWarnings, NameALandmarkThatLiesOnAnotherTracedTooth)
{
  const PhantomCase phantom(6, PhantomCase::SideEnum::Right, 16000);
  const std::string words = "the result puts UR6_MB";
  EXPECT_FALSE(HasLineWith(Register(phantom).warnings, "the result puts "));
  const auto * tooth = phantom.data->landmarks3D->Find("UR6_MB");
  const auto * behind = phantom.data->landmarks3D->Find("UR7_MB");
  ASSERT_TRUE(tooth != nullptr && behind != nullptr);
  const auto shift = behind->point - tooth->point;
  auto       slipped = itk::DentalLandmarkSet<3>::New();
  for (const auto & landmark : phantom.data->landmarks3D->GetLandmarks())
  {
    if (landmark.tooth.IsRight() && landmark.name.rfind("UR7", 0) != 0)
    {
      const bool isSlipped = landmark.name.rfind("UR6", 0) == 0;
      slipped->AddLandmark(landmark.name, isSlipped ? landmark.point + shift : landmark.point);
    }
  }
  phantom.data->landmarks3D = slipped;
  EXPECT_TRUE(HasLineWith(Register(phantom).warnings, words));
  // The middle of both sides is no place of either.
  phantom.data->description.tracedSide = itk::TracedSideEnum::Mean;
  EXPECT_FALSE(HasLineWith(Register(phantom).warnings, words));
}

/** Where the scan has no landmarks a molar is looked for at a textbook's place, and beside a tracing where that has it.
 * Of one that lies where the scan shows no tooth a textbook's place is all there is, and the tracing says that it is
 * not there. */
TEST(CaseWarnings, NameAMiddleThatLiesOnAnotherTracedTooth)
{
  for (const bool isAnother : { true, false })
  {
    const PhantomCase phantom(77011, PhantomCase::SideEnum::Right, 12000);
    phantom.data->landmarks3D = nullptr;
    for (const JawEnum jaw : Jaws)
    {
      auto moved = itk::DentalContour::New();
      for (auto polyline : phantom.data->GetJaw(jaw).contour->GetPolylines())
      {
        if (isAnother && polyline.code.GetPosition() == 6)
        {
          // The line itself stays, so that the jaw lies where it did, by its neighbour's code; its own is that of one
          // beyond the last tooth.
          itk::DentalContour::PolylineType elsewhere;
          elsewhere.code = polyline.code;
          for (unsigned int k = 0; k < 10; ++k)
          {
            elsewhere.points.push_back(polyline.points.front());
            elsewhere.points.back()[0] -= 200.0 + 2.0 * k;
          }
          elsewhere.weights.assign(elsewhere.points.size(), 1e-3);
          moved->AddPolyline(elsewhere);
          polyline.code = itk::ToothCode(polyline.code.GetFDI() + 1u);
        }
        // Twice as many points, beside which the others are few.
        auto dense = polyline;
        dense.points.clear();
        for (std::size_t i = 0; i + 1 < polyline.points.size(); ++i)
        {
          itk::DentalContour::PointType between;
          between.SetToMidPoint(polyline.points[i], polyline.points[i + 1]);
          dense.points.push_back(polyline.points[i]);
          dense.points.push_back(between);
        }
        moved->AddPolyline(dense);
      }
      phantom.data->GetJaw(jaw).contour = moved;
    }
    const auto result = Register(phantom);
    for (const auto & entry : result.jaws)
    {
      const std::string name = std::string(entry.first == JawEnum::Upper ? "U" : "L") + "6_MB";
      EXPECT_EQ(HasLineWith(result.warnings, "middles: " + name + " is "), isAnother) << name;
      // That the jaw lies where it should is not in doubt for it.
      EXPECT_EQ(entry.second.status, itk::RegistrationStatusEnum::Ok) << name;
    }
  }
}

/** As far from the corner and as large as it would be in mm, or on a copy of half the size. */
TEST(CaseWarnings, NameTheJawThatWasDrawnOnAnotherCopy)
{
  const std::string words = "what was drawn of the lower jaw is 0.";
  for (const bool inMillimetres : { true, false })
  {
    const PhantomCase phantom(6, PhantomCase::SideEnum::Right, 16000);
    const double      factor = inMillimetres ? phantom.data->geometry->GetPixelSpacing()[0] : 0.5;
    auto              smaller = itk::DentalContour::New();
    for (auto polyline : phantom.data->lower.contour->GetPolylines())
    {
      for (auto & point : polyline.points)
      {
        point[0] *= factor;
        point[1] *= factor;
      }
      smaller->AddPolyline(polyline);
    }
    phantom.data->lower.contour = smaller;
    const auto result = Register(phantom);
    EXPECT_TRUE(HasLineWith(result.warnings, words));
    EXPECT_EQ(HasLineWith(result.warnings, "is it in mm? Give pixels"), inMillimetres);
  }
}

INSTANTIATE_TEST_SUITE_P(All,
                         CaseMistakes,
                         ::testing::Values(Mistake{ "JawsExchanged", ExchangeJaws, "exchanged" },
                                           Mistake{ "WrongUnit", SayCentimetres, "\"mesh_unit\": \"mm\" would fit" },
                                           Mistake{ "WrongFacing", FaceLeft, "facing" },
                                           Mistake{ "OtherSideTraced", SayLeft, "check traced_side" },
                                           Mistake{ "MirroredScan", Mirror, "mirrored" },
                                           Mistake{ "WrongSpacing", StretchSpacing, "contradicts pixel spacing" },
                                           Mistake{ "IncisorsOnly", KeepIncisors, "trace more teeth" }),
                         [](const auto & test) { return std::string(test.param.name); });

TEST_P(CaseTracedSide, EverySideIsRegisteredWithinTwoPixels)
{
  const PhantomCase phantom(5, GetParam().phantom, 16000);
  phantom.data->description.tracedSide = GetParam().said;
  const auto result = Register(phantom);
  for (const auto & jaw : result.jaws)
  {
    ASSERT_TRUE(jaw.second.error);
    // What issue and paper ask for, half a millimetre.
    EXPECT_LT(jaw.second.error->mean, 2.0) << jaw.first;
  }
}

INSTANTIATE_TEST_SUITE_P(All,
                         CaseTracedSide,
                         ::testing::Values(Side{ "Left", PhantomCase::SideEnum::Left, itk::TracedSideEnum::Left },
                                           Side{ "Both", PhantomCase::SideEnum::Both, itk::TracedSideEnum::Both },
                                           Side{ "Mean", PhantomCase::SideEnum::Mean, itk::TracedSideEnum::Mean }),
                         [](const auto & test) { return std::string(test.param.name); });
