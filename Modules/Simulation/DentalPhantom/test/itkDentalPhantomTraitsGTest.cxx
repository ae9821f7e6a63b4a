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
#include "itkDentalPhantomTraits.h"

#include "itkDentalPhantomTestCase.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <tuple>

using namespace DentalPhantomTestCase;

namespace
{
/** Overbite at the right central incisors, mm: how far the lower edge stands above the upper one. */
double
Overbite(CaseType * source)
{
  return Landmark(source, "LR1_tip")[2] - Landmark(source, "UR1_tip")[2];
}

/** The index of a tooth. */
const itk::DentalPhantomTooth &
Tooth(const CaseType * source, unsigned int fdi)
{
  const unsigned int quadrant = fdi / 10;
  return source->GetParameters().jaws[quadrant > 2 ? 1 : 0].GetTooth(
    itk::DentalPhantomJaw::GetIndex(quadrant == 2 || quadrant == 3, fdi % 10 - 1));
}

std::string
Code(unsigned int fdi)
{
  return itk::ToothCode(fdi).GetName();
}

/** Everything of a tooth but its bracket. */
std::vector<double>
Shape(const itk::DentalPhantomTooth & tooth)
{
  return { tooth.missing ? 1.0 : 0.0,
           tooth.mesiodistal,
           tooth.buccolingual,
           tooth.height,
           tooth.rotation,
           tooth.tip,
           tooth.torque,
           tooth.buccalOffset,
           tooth.occlusalOffset,
           tooth.mesialGap,
           tooth.wear,
           tooth.primary ? 1.0 : 0.0,
           tooth.settles ? 1.0 : 0.0 };
}

const std::vector<std::string> &
Keys()
{
  static const std::vector<std::string> keys = {
    "extraction_closed", "extraction_open", "milk_molar", "third_molar",         "infraocclusion",    "wear",
    "crowding",          "open_bite",       "deep_bite",  "crossbite_posterior", "crossbite_anterior"
  };
  return keys;
}

std::string
Only(const std::string & key, const std::string & more = "")
{
  return "{\"traits\": {\"" + key + "_probability\": 1" + more + "}}";
}
} // namespace

TEST(DentalPhantomTraits, OpenBiteLeavesTheStatedGapBetweenTheIncisors)
{
  for (const std::uint64_t seed : { 1, 2, 3, 4 })
  {
    const auto source = Make(seed, Only("open_bite"));
    const auto trait = Find(source, "open_bite");
    ASSERT_NE(trait, nullptr);
    EXPECT_GE(trait->amount, 1.0);
    // Single teeth stand up to 2.5 x 0.15 mm off the arch, in both jaws, and the lower edge settles down only.
    EXPECT_NEAR(-Overbite(source), trait->amount, 1.1) << seed;
    EXPECT_LT(Overbite(source), -0.6) << seed;
    // The molars meet all the same: an open bite is not a bite propped open.
    double meets = 1e9;
    for (const auto & p : Crown(source, 46))
    {
      for (const auto & q : Crown(source, 16))
      {
        meets = std::min(meets, std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
      }
    }
    EXPECT_LT(meets, 0.8) << seed;
  }
}

TEST(DentalPhantomTraits, DeepBiteCoversTheLowerIncisors)
{
  double mean = 0.0;
  for (const std::uint64_t seed : { 1, 2, 3, 4 })
  {
    const auto source = Make(seed, Only("deep_bite"));
    ASSERT_NE(Find(source, "deep_bite"), nullptr);
    mean += Overbite(source) / 4.0;
    // The lower edge stands behind the upper one.
    EXPECT_GT(Landmark(source, "UR1_tip")[0], Landmark(source, "LR1_tip")[0] + 1.0) << seed;
    EXPECT_GT(Overbite(source), 3.0) << seed;
  }
  // A deep bite is one of more than 4 mm; settling may take some from a single incisor.
  EXPECT_GT(mean, 4.0);
}

TEST(DentalPhantomTraits, CrossbiteReversesTheBuccalOverlapOfItsTeethAlone)
{
  for (const std::uint64_t seed : { 1, 2, 3, 5 })
  {
    const auto source = Make(seed, Only("crossbite_posterior"));
    const auto trait = Find(source, "crossbite_posterior");
    ASSERT_NE(trait, nullptr);
    for (const bool left : { false, true })
    {
      const bool crossed = std::find(trait->teeth.begin(), trait->teeth.end(), left ? 26u : 16u) != trait->teeth.end();
      const std::string side = left ? "L" : "R";
      // How far the upper buccal cusp stands outside of the lower one.
      const double upper = std::abs(Landmark(source, "U" + side + "6_MB")[1]);
      const double lower = std::abs(Landmark(source, "L" + side + "6_MB")[1]);
      if (crossed)
      {
        EXPECT_LT(upper - lower, -0.8) << seed;
      }
      else
      {
        EXPECT_GT(upper - lower, 0.8) << seed;
      }
    }
  }
}

TEST(DentalPhantomTraits, AnteriorCrossbiteHasTheLowerIncisorsInFront)
{
  for (const std::uint64_t seed : { 1, 2, 3 })
  {
    const auto source = Make(seed, Only("crossbite_anterior"));
    ASSERT_NE(Find(source, "crossbite_anterior"), nullptr);
    for (const char * side : { "R", "L" })
    {
      EXPECT_GT(Landmark(source, std::string("L") + side + "1_tip")[0],
                Landmark(source, std::string("U") + side + "1_tip")[0] + 0.8)
        << seed;
    }
  }
}

TEST(DentalPhantomTraits, ThirdMolarsStandBehindTheSecondOnOneOrBothSides)
{
  int one = 0;
  int both = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed)
  {
    const auto source = Make(seed, Only("third_molar"), 8000);
    const auto trait = Find(source, "third_molar");
    ASSERT_NE(trait, nullptr);
    for (const unsigned int jaw : { 0u, 1u })
    {
      const auto         teeth = Teeth(source, jaw);
      const unsigned int right = jaw == 0 ? 18 : 48;
      const unsigned int left = jaw == 0 ? 28 : 38;
      EXPECT_EQ(teeth.size(), 14 + teeth.count(right) + teeth.count(left)) << seed;
      one += teeth.count(right) + teeth.count(left) == 1;
      both += teeth.count(right) + teeth.count(left) == 2;
      for (const unsigned int fdi : { right, left })
      {
        EXPECT_EQ(teeth.count(fdi) == 1,
                  std::find(trait->teeth.begin(), trait->teeth.end(), fdi) != trait->teeth.end());
        if (teeth.count(fdi) == 1)
        {
          EXPECT_LT(Landmark(source, Code(fdi) + "_MB")[0], Landmark(source, Code(fdi - 1) + "_MB")[0] - 5.0) << fdi;
        }
      }
    }
  }
  EXPECT_GT(one, 0);
  EXPECT_GT(both, 0);
}

TEST(DentalPhantomTraits, ClosedExtractionGapsAreContactsAndTheNeighboursLeanIntoThem)
{
  int oneSided = 0;
  for (const std::uint64_t seed : { 1, 2, 3, 4, 5, 6 })
  {
    const auto source = Make(seed, Only("extraction_closed"), 10000);
    const auto plain = Make(seed, "{}", 2000);
    const auto trait = Find(source, "extraction_closed");
    ASSERT_NE(trait, nullptr);
    oneSided += trait->teeth.size() == 1;
    for (const unsigned int fdi : trait->teeth)
    {
      EXPECT_EQ(Teeth(source, fdi / 10 > 2 ? 1 : 0).count(fdi), 0u);
      // What is left of a 7 mm place: the residual, what the tips of two inclined crowns open, and the distance of the
      // nearest vertices (0.6 mm apart on either side).
      EXPECT_LT(Gap(source, fdi - 1, fdi + 1), trait->amount + 1.6) << seed << " " << fdi;
      EXPECT_GT(Tooth(source, fdi + 1).tip, Tooth(plain, fdi + 1).tip);
      EXPECT_LT(Tooth(source, fdi - 1).tip, Tooth(plain, fdi - 1).tip);
    }
  }
  EXPECT_GT(oneSided, 0);
}

TEST(DentalPhantomTraits, OpenExtractionGapsKeepTheStatedWidth)
{
  for (const std::uint64_t seed : { 1, 2, 3, 4, 5 })
  {
    const auto source = Make(seed, Only("extraction_open"));
    const auto trait = Find(source, "extraction_open");
    ASSERT_NE(trait, nullptr);
    ASSERT_EQ(trait->teeth.size(), 1u);
    const unsigned int fdi = trait->teeth[0];
    EXPECT_EQ(Teeth(source, fdi / 10 > 2 ? 1 : 0).count(fdi), 0u);
    const double whole = Tooth(Make(seed, "{}", 2000), fdi).mesiodistal;
    const double gap = Gap(source, fdi - 1, fdi + 1);
    // A place is as wide as the gap at the contacts' height. Crowns that tip into it pivot at their occlusal surface:
    // up to a centimetre of crown leans by 20 degrees, and turned ones show their narrow side.
    EXPECT_GT(gap, trait->amount - 0.8) << seed << " " << fdi;
    EXPECT_LT(gap, trait->amount + 3.2) << seed << " " << fdi;
    EXPECT_LT(trait->amount, whole);
    EXPECT_GT(gap, 0.3) << seed;
  }
}

TEST(DentalPhantomTraits, MilkMolarsAreMolarsInAPremolarsPlace)
{
  for (const std::uint64_t seed : { 1, 2, 3, 4 })
  {
    const auto source = Make(seed, Only("milk_molar"));
    const auto plain = Make(seed, "{}");
    const auto trait = Find(source, "milk_molar");
    ASSERT_NE(trait, nullptr);
    for (const unsigned int fdi : trait->teeth)
    {
      EXPECT_TRUE(fdi % 10 == 4 || fdi % 10 == 5);
      EXPECT_EQ(Teeth(source, fdi / 10 > 2 ? 1 : 0).count(fdi), 1u);
      // Four cusps: the mesiobuccal one is marked, where a premolar has its B.
      EXPECT_NO_THROW(Landmark(source, Code(fdi) + "_MB"));
      EXPECT_THROW(Landmark(source, Code(fdi) + "_B"), std::runtime_error);
      if (fdi % 10 == 5 && fdi > 30)
      {
        // A lower second milk molar is 9.9 mm wide, a second premolar 7.1.
        EXPECT_GT(Tooth(source, fdi).mesiodistal, Tooth(plain, fdi).mesiodistal + 1.5);
        EXPECT_GT(Extent(source, fdi), Extent(plain, fdi) + 0.8);
      }
    }
  }
}

TEST(DentalPhantomTraits, InfraoccludedMolarIsAStepBelowItsNeighbours)
{
  for (const std::uint64_t seed : { 1, 2, 3, 4 })
  {
    const auto source = Make(seed, Only("infraocclusion"));
    const auto trait = Find(source, "infraocclusion");
    ASSERT_NE(trait, nullptr);
    const unsigned int fdi = trait->teeth.at(0);
    const double       up = fdi > 30 ? 1.0 : -1.0;
    const auto         height = [&](unsigned int tooth) {
      double highest = -1e9;
      for (const auto & p : Crown(source, tooth))
      {
        highest = std::max(highest, up * p[2]);
      }
      return highest;
    };
    const double step = 0.5 * (height(fdi - 1) + height(fdi + 1)) - height(fdi);
    // The curve of Spee and the tooth's own offset make up to a millimetre beside it.
    EXPECT_NEAR(step, trait->amount, 1.3) << seed << " " << fdi;
    EXPECT_GT(step, 0.8) << seed;
  }
}

TEST(DentalPhantomTraits, WornMolarsAreFlat)
{
  for (const std::uint64_t seed : { 1, 2 })
  {
    double relief[2];
    for (const bool worn : { false, true })
    {
      const auto source = Make(seed, worn ? Only("wear", ", \"wear_mm\": 2.4") : "{}", 40000);
      // Between the highest and the lowest point of the occlusal table's middle.
      double     low = 1e9;
      double     high = -1e9;
      const auto mb = Landmark(source, "LR6_MB");
      const auto db = Landmark(source, "LR6_DB");
      for (const auto & p : Crown(source, 46))
      {
        const double x = p[0] - 0.5 * (mb[0] + db[0]);
        const double y = p[1] - 0.5 * (mb[1] + db[1]) - 2.0;
        if (x * x + y * y < 2.5 * 2.5)
        {
          low = std::min(low, p[2]);
          high = std::max(high, p[2]);
        }
      }
      relief[worn] = high - low;
    }
    EXPECT_LT(relief[1], 0.75 * relief[0]) << seed;
  }
}

TEST(DentalPhantomTraits, CrowdingPutsALateralIncisorForemost)
{
  int upper = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
  {
    const auto source = Make(seed, Only("crowding"), 10000);
    const auto trait = Find(source, "crowding");
    ASSERT_NE(trait, nullptr);
    for (const unsigned int fdi : trait->teeth)
    {
      EXPECT_EQ(fdi % 10, 2u);
      if (fdi < 30)
      {
        ++upper;
        EXPECT_GT(Landmark(source, Code(fdi) + "_tip")[0], Landmark(source, Code(fdi - 1) + "_tip")[0]) << seed;
      }
      // Neighbours overlap.
      EXPECT_LT(Tooth(source, fdi).mesialGap, -0.5);
    }
  }
  EXPECT_GT(upper, 2);
}

TEST(DentalPhantomTraits, OneMoreTraitLeavesTheOthersAsTheyWere)
{
  // Those that want a tooth or a bite which the trait before them in the list may have; all others have a random stream
  // of their own and are what they were.
  const std::map<std::string, std::set<std::string>> yield = {
    { "extraction_closed", { "extraction_open", "milk_molar", "infraocclusion", "bracket" } },
    { "extraction_open", { "milk_molar", "infraocclusion", "bracket" } },
    { "milk_molar", { "infraocclusion" } },
    { "open_bite", { "deep_bite", "crossbite_anterior" } },
    { "deep_bite", { "crossbite_anterior" } },
  };
  using TraitType = std::tuple<std::string, std::vector<unsigned int>, double>;
  std::map<std::string, int> compared;
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
  {
    // All at 0.5, then one of them never and always.
    LevelType   level;
    std::string half;
    for (const auto & key : Keys())
    {
      half += (half.empty() ? "" : ", ") + ("\"" + key + "_probability\": 0.5");
    }
    level.ParseJson("{\"traits\": {" + half +
                      "}, \"scan\": {\"bracket_probability\": 0.5, \"flap_probability\": 0.5, "
                      "\"crumb_probability\": 0.5, \"mean_specks\": 3, \"mean_holes\": 3}}",
                    "test");
    std::vector<std::string> keys = Keys();
    keys.insert(keys.end(), { "bracket", "flap", "crumb" });
    for (const auto & key : keys)
    {
      const std::string            section = key == "bracket" || key == "flap" || key == "crumb" ? "scan" : "traits";
      itk::DentalPhantomParameters parameters[2];
      std::set<TraitType>          others[2];
      bool                         has[2] = { false, false };
      for (const int given : { 0, 1 })
      {
        LevelType changed = level;
        changed.ParseJson("{\"" + section + "\": {\"" + key + "_probability\": " + std::to_string(given) + "}}",
                          "test");
        parameters[given] = itk::DentalPhantomParameters::Draw(seed);
        for (const auto & trait : itk::DentalPhantomTraits::Apply(seed, changed, parameters[given]))
        {
          const auto found = yield.find(key);
          if (trait.name == key)
          {
            has[given] = true;
          }
          else if (found == yield.end() || found->second.count(trait.name) == 0)
          {
            others[given].insert({ trait.name, { trait.teeth.begin(), trait.teeth.end() }, trait.amount });
          }
        }
      }
      EXPECT_FALSE(has[0]) << key << ' ' << seed;
      EXPECT_EQ(others[0], others[1]) << key << ' ' << seed;
      compared[key] += has[1] ? static_cast<int>(others[0].size()) : 0;
      // The teeth themselves: brackets and things of the scan move none, third molars none of the others.
      if (section == "scan" || key == "third_molar")
      {
        for (const unsigned int jaw : { 0u, 1u })
        {
          for (unsigned int i = 0; i < 14; ++i)
          {
            EXPECT_EQ(Shape(parameters[0].jaws[jaw].teeth[i]), Shape(parameters[1].jaws[jaw].teeth[i]))
              << key << ' ' << seed << ' ' << jaw << ' ' << i;
          }
        }
      }
    }
  }
  // Each trait was given in some cases, and others with it: of 20 at least a handful.
  for (const auto & entry : compared)
  {
    EXPECT_GT(entry.second, 20) << entry.first;
  }
}

TEST(DentalPhantomTraits, EveryTraitOccursAsOftenAsTheLevelSaysAndNeverMakesAnInvalidJaw)
{
  const LevelType            level = LevelType::Named("real");
  std::map<std::string, int> found;
  constexpr int              cases = 1000;
  for (std::uint64_t seed = 1; seed <= cases; ++seed)
  {
    auto parameters = itk::DentalPhantomParameters::Draw(seed);
    for (const auto & trait : itk::DentalPhantomTraits::Apply(seed, level, parameters))
    {
      ++found[trait.name];
    }
    EXPECT_NO_THROW(parameters.Validate()) << seed;
  }
  // Binomial sd below 15; some give way to another trait of the same tooth.
  EXPECT_NEAR(found["extraction_closed"], 200, 50);
  EXPECT_NEAR(found["extraction_open"], 150, 60);
  EXPECT_NEAR(found["milk_molar"], 150, 60);
  EXPECT_NEAR(found["third_molar"], 300, 60);
  EXPECT_NEAR(found["infraocclusion"], 80, 40);
  EXPECT_NEAR(found["wear"], 150, 50);
  EXPECT_NEAR(found["crowding"], 300, 60);
  EXPECT_NEAR(found["open_bite"], 80, 40);
  EXPECT_NEAR(found["deep_bite"], 140, 50);
  EXPECT_NEAR(found["crossbite_posterior"], 150, 50);
  EXPECT_NEAR(found["crossbite_anterior"], 45, 30);
  EXPECT_NEAR(found["bracket"], 100, 40);
  EXPECT_NEAR(found["flap"], 250, 60);
}

TEST(DentalPhantomTraits, BracketsStandOffTheCrownsAndAreNotTraced)
{
  const std::string scan =
    ", \"mean_holes\": 0, \"mean_specks\": 0}, \"tracing\": {\"drift_px\": 0, \"jitter_px\": 0}}";
  const auto bonded = Make(3, "{\"scan\": {\"bracket_probability\": 1" + scan, 40000);
  // Decimation to as many triangles as there are takes nothing, but makes the tracing that of the clean jaw as well.
  const auto plain = Make(3, "{\"scan\": {\"decimate_to\": 3999999" + scan, 40000);
  ASSERT_NE(Find(bonded, "bracket"), nullptr);
  const auto foremost = [](CaseType * source) {
    double x = -1e9;
    for (const auto & p : Crown(source, 11))
    {
      x = std::max(x, p[0]);
    }
    return x;
  };
  // 1.65 mm in the middle of the crown, of which the crown's own bulge and inclination hide a part.
  EXPECT_GT(foremost(bonded), foremost(plain) + 0.7);
  for (const unsigned int jaw : { 0u, 1u })
  {
    ASSERT_EQ(bonded->GetTrueTracing(jaw)->GetNumberOfPoints(), plain->GetTrueTracing(jaw)->GetNumberOfPoints());
    for (itk::IdentifierType i = 0; i < plain->GetTrueTracing(jaw)->GetNumberOfPoints(); ++i)
    {
      // The head is centred at the scan's crowns, brackets included: the whole picture moves by a pixel or two at most.
      EXPECT_LT(bonded->GetTrueTracing(jaw)->GetPoint(i).EuclideanDistanceTo(plain->GetTrueTracing(jaw)->GetPoint(i)),
                2.0);
    }
  }
}
