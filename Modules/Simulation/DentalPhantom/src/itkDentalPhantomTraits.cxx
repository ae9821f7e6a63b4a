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

#include "itkDentalPhantomDentition.h"
#include "itkDentalPhantomMath.h"
#include "itkReproducibleRandom.h"

#include <algorithm>
#include <cmath>

namespace itk
{
using namespace DentalPhantomMath;

namespace
{
/** A stream a trait; never reuse a number. */
enum TraitStream : std::uint64_t
{
  ClosedExtractionStream = 301,
  OpenExtractionStream = 302,
  MilkMolarStream = 303,
  ThirdMolarStream = 304,
  InfraocclusionStream = 305,
  WearStream = 306,
  CrowdingStream = 307,
  OpenBiteStream = 308,
  DeepBiteStream = 309,
  PosteriorCrossbiteStream = 310,
  AnteriorCrossbiteStream = 311,
  BracketStream = 312,
  FlapStream = 313,
  CrumbStream = 314,
  SpeckStream = 315,
  HoleStream = 316,
  ScanStream = 317,
  GingivaStream = 4711
};

class Giver
{
public:
  Giver(std::uint64_t seed, const DentalPhantomLevel & level, DentalPhantomParameters & parameters)
    : m_Seed(seed)
    , m_Level(level)
    , m_Parameters(parameters)
  {}

  void
  ExtractAndClose()
  {
    ReproducibleRandom random(m_Seed, ClosedExtractionStream);
    const bool         occurs = random.Uniform() < m_Level.closedExtractionProbability;
    const bool         oneSided = random.Uniform() < m_Level.oneSidedExtractionProbability;
    const bool         upperOnly = random.Uniform() < 0.35;
    const unsigned int quadrant = random.Integer(4);
    // First premolars in seven cases of ten.
    const unsigned int position = random.Uniform() < 0.7 ? 3 : 4;
    DentalPhantomTrait trait{ "extraction_closed", {}, 0.0 };
    for (unsigned int q = 0; q < 4; ++q)
    {
      const double       residual = random.Uniform() * m_Level.closedExtractionResidual;
      const double       distalTip = random.Uniform(2.0, 7.0);
      const double       mesialTip = random.Uniform(1.0, 5.0);
      const double       turn = random.Normal(0.0, 4.0);
      const unsigned int jaw = q / 2;
      const bool         left = q % 2 == 1;
      if (!occurs || (oneSided ? q != quadrant : upperOnly && jaw == 1))
      {
        continue;
      }
      DentalPhantomTooth & tooth = this->Tooth(jaw, left, position);
      tooth.missing = true;
      tooth.mesiodistal = residual;
      tooth.mesialGap = 0.0;
      // The roots follow the crowns only in part: both neighbours still lean into the gap.
      this->Tooth(jaw, left, position - 1).tip -= mesialTip * Degree;
      DentalPhantomTooth & distal = this->Tooth(jaw, left, position + 1);
      distal.tip += distalTip * Degree;
      distal.rotation += turn * Degree;
      // Contact; a spaced arch's gap beside it would reopen what was closed.
      distal.mesialGap = std::min(distal.mesialGap, 0.0);
      trait.teeth.push_back(this->FDI(jaw, left, position));
      trait.amount = std::max(trait.amount, residual);
    }
    this->Note(trait);
  }

  void
  LoseAndDrift()
  {
    ReproducibleRandom random(m_Seed, OpenExtractionStream);
    const bool         occurs = random.Uniform() < m_Level.openExtractionProbability;
    const unsigned int jaw = random.Uniform() < 0.6 ? 1 : 0;
    const bool         left = random.Uniform() < 0.5;
    // The first molar is the tooth that is lost most often.
    const unsigned int position = random.Uniform() < 0.6 ? 5 : random.Uniform() < 0.5 ? 4 : 3;
    const double       closure = random.Uniform(0.05, std::max(0.05, m_Level.openExtractionClosure));
    const double       distalTip = random.Uniform(6.0, 14.0) + 8.0 * closure;
    const double       mesialTip = random.Uniform(2.0, 6.0);
    const double       turn = random.Uniform(2.0, 12.0);
    const double       drift = random.Uniform(0.1, 0.6);
    const double       eruption = random.Uniform(0.3, 1.8);
    if (!occurs || this->IsTaken(jaw, left, position))
    {
      return;
    }
    DentalPhantomTooth & tooth = this->Tooth(jaw, left, position);
    tooth.missing = true;
    // The distal tooth tips and drifts mesially; the mesial one drifts back and opens a contact before it.
    DentalPhantomTooth & distal = this->Tooth(jaw, left, position + 1);
    DentalPhantomTooth & mesial = this->Tooth(jaw, left, position - 1);
    tooth.mesiodistal = std::max(0.6, tooth.mesiodistal * (1.0 - closure) - drift);
    mesial.mesialGap = std::max(mesial.mesialGap, 0.0) + drift;
    mesial.tip -= mesialTip * Degree;
    distal.tip += distalTip * Degree;
    distal.rotation += turn * Degree;
    // The antagonist follows into the gap.
    DentalPhantomTooth & antagonist = this->Tooth(1 - jaw, left, position);
    if (!antagonist.missing)
    {
      antagonist.occlusalOffset += eruption;
    }
    this->Note({ "extraction_open", { this->FDI(jaw, left, position) }, tooth.mesiodistal });
  }

  void
  KeepMilkMolars()
  {
    ReproducibleRandom random(m_Seed, MilkMolarStream);
    const bool         occurs = random.Uniform() < m_Level.milkMolarProbability;
    const unsigned int jaw = random.Uniform() < 0.7 ? 1 : 0;
    const bool         both = random.Uniform() < 0.35;
    const bool         left = random.Uniform() < 0.5;
    // The second milk molar of a lower jaw is the one that most often has no successor.
    const unsigned int position = random.Uniform() < 0.85 ? 4 : 3;
    DentalPhantomTrait trait{ "milk_molar", {}, 0.0 };
    for (unsigned int side = 0; side < 2; ++side)
    {
      const double size = 1.0 + 0.03 * random.Normal();
      const double wear = random.Uniform(0.3, 0.8);
      const double depth = random.Uniform(0.2, 1.0);
      const double turn = 2.0 * random.Normal();
      const bool   isLeft = (side == 0) == left;
      if (!occurs || (side == 1 && !both) || this->IsTaken(jaw, isLeft, position))
      {
        continue;
      }
      // Mesiodistal, buccolingual, height: Nelson and Ash, Wheeler's Dental Anatomy.
      constexpr double     sizes[2][2][3] = { { { 7.3, 8.5, 5.1 }, { 8.2, 10.0, 5.7 } },
                                              { { 7.7, 7.0, 6.0 }, { 9.9, 8.7, 5.5 } } };
      const double *       mean = sizes[jaw][position - 3];
      DentalPhantomTooth & tooth = this->Tooth(jaw, isLeft, position);
      tooth.primary = true;
      tooth.mesiodistal = size * mean[0];
      tooth.buccolingual = size * mean[1];
      tooth.height = size * mean[2];
      tooth.wear = wear;
      tooth.rotation = turn * Degree;
      tooth.occlusalOffset = -depth;
      tooth.settles = false;
      trait.teeth.push_back(this->FDI(jaw, isLeft, position));
      trait.amount = tooth.mesiodistal;
    }
    this->Note(trait);
  }

  void
  AddThirdMolars()
  {
    ReproducibleRandom random(m_Seed, ThirdMolarStream);
    const bool         occurs = random.Uniform() < m_Level.thirdMolarProbability;
    const double       which = random.Uniform();
    DentalPhantomTrait trait{ "third_molar", {}, 0.0 };
    for (unsigned int jaw = 0; jaw < 2; ++jaw)
    {
      const bool   oneSided = random.Uniform() < m_Level.oneSidedThirdMolarProbability;
      const bool   leftOnly = random.Uniform() < 0.5;
      const double size = 1.0 + 0.07 * std::min(std::max(random.Normal(), -2.0), 2.0);
      for (unsigned int side = 0; side < 2; ++side)
      {
        const double tip = jaw == 0 ? random.Uniform(-15.0, 5.0) : random.Uniform(0.0, 28.0);
        const double depth = random.Uniform(0.2, 3.0);
        const double turn = 8.0 * random.Normal();
        const double gap = random.Uniform(0.0, 0.5);
        const double buccal = random.Uniform(-0.5, 1.0);
        const bool   hasJaw = which < 0.5 || (which < 0.75) == (jaw == 0);
        if (!occurs || !hasJaw || (oneSided && leftOnly != (side == 1)))
        {
          continue;
        }
        DentalPhantomTooth & tooth = m_Parameters.jaws[jaw].thirdMolars[side];
        tooth.missing = false;
        tooth.mesiodistal *= size;
        tooth.buccolingual *= size;
        // Not all the way erupted; lower ones lean forward.
        tooth.occlusalOffset = -depth;
        tooth.settles = false;
        tooth.tip = tip * Degree;
        tooth.rotation = turn * Degree;
        tooth.buccalOffset = buccal;
        tooth.mesialGap = gap;
        trait.teeth.push_back(this->FDI(jaw, side == 1, 7));
        trait.amount = std::max(trait.amount, depth);
      }
    }
    this->Note(trait);
  }

  void
  SinkMolar()
  {
    ReproducibleRandom random(m_Seed, InfraocclusionStream);
    const bool         occurs = random.Uniform() < m_Level.infraocclusionProbability;
    unsigned int       jaw = random.Uniform() < 0.7 ? 1 : 0;
    bool               left = random.Uniform() < 0.5;
    const double       depth = random.Uniform(1.5, std::max(1.5, m_Level.infraocclusionDepth));
    const double       tips[2] = { random.Uniform(4.0, 10.0), random.Uniform(3.0, 8.0) };
    unsigned int       position = 5;
    for (unsigned int q = 0; q < 8; ++q)
    {
      if (this->Tooth(q / 4, q % 2 == 1, 3 + q / 2 % 2).primary)
      {
        jaw = q / 4;
        left = q % 2 == 1;
        position = 3 + q / 2 % 2;
      }
    }
    DentalPhantomTooth & tooth = this->Tooth(jaw, left, position);
    if (!occurs || tooth.missing)
    {
      return;
    }
    // Ankylosed: the jaw grows on, the tooth stays; its neighbours tip over it.
    tooth.occlusalOffset = -depth;
    tooth.settles = false;
    this->Tooth(jaw, left, position + 1).tip += tips[0] * Degree;
    this->Tooth(jaw, left, position - 1).tip -= tips[1] * Degree;
    this->Note({ "infraocclusion", { this->FDI(jaw, left, position) }, depth });
  }

  void
  Wear()
  {
    ReproducibleRandom random(m_Seed, WearStream);
    const bool         occurs = random.Uniform() < m_Level.wearProbability;
    const double       depth = random.Uniform(0.5, std::max(0.5, m_Level.wearDepth));
    for (unsigned int jaw = 0; jaw < 2; ++jaw)
    {
      for (unsigned int i = 0; i < 14; ++i)
      {
        const double         own = random.Uniform(0.8, 1.1);
        DentalPhantomTooth & tooth = m_Parameters.jaws[jaw].teeth[i];
        if (!occurs || tooth.primary)
        {
          continue;
        }
        // Edges and canines lose less; worn teeth erupt on until they meet again.
        const double worn = own * depth * (i % 7 >= 3 ? 1.0 : 0.4);
        tooth.wear = std::min(worn, 2.4);
        tooth.occlusalOffset += tooth.wear;
      }
    }
    if (occurs)
    {
      this->Note({ "wear", {}, depth }, true);
    }
  }

  void
  Crowd()
  {
    ReproducibleRandom random(m_Seed, CrowdingStream);
    const bool         occurs = random.Uniform() < m_Level.crowdingProbability;
    const double       jaws = random.Uniform();
    const double       overlap = random.Uniform(0.5, 1.0) * m_Level.crowdingOverlap;
    const bool         bothLaterals = random.Uniform() < 0.4;
    const bool         leftFirst = random.Uniform() < 0.5;
    DentalPhantomTrait trait{ "crowding", {}, overlap };
    for (unsigned int jaw = 0; jaw < 2; ++jaw)
    {
      const bool crowded = occurs && (jaws < 0.5 || (jaws < 0.75) == (jaw == 0));
      for (unsigned int side = 0; side < 2; ++side)
      {
        double draws[6];
        for (double & draw : draws)
        {
          draw = random.Uniform();
        }
        if (!crowded)
        {
          continue;
        }
        DentalPhantomTooth & central = this->Tooth(jaw, side == 1, 0);
        DentalPhantomTooth & lateral = this->Tooth(jaw, side == 1, 1);
        DentalPhantomTooth & canine = this->Tooth(jaw, side == 1, 2);
        lateral.mesialGap = -overlap;
        canine.mesialGap = -0.6 * overlap;
        lateral.rotation += (draws[0] - 0.3) * 30.0 * Degree;
        central.rotation += (draws[1] - 0.5) * 20.0 * Degree;
        canine.rotation += (draws[2] - 0.5) * 20.0 * Degree;
        if (bothLaterals || (side == 1) == leftFirst)
        {
          // Foremost: in front of a central incisor that stands back. The arch curves back by some 2 mm from the one to
          // the other, more where it is narrow.
          lateral.buccalOffset = 3.6 + 1.2 * draws[3];
          central.buccalOffset = -0.7 - 0.6 * draws[4];
          this->Tooth(jaw, side == 0, 0).buccalOffset = std::min(this->Tooth(jaw, side == 0, 0).buccalOffset, -0.2);
          trait.teeth.push_back(this->FDI(jaw, side == 1, 1));
        }
        else
        {
          lateral.buccalOffset = -0.8 - draws[3];
        }
      }
    }
    this->Note(trait);
  }

  void
  OpenBite()
  {
    ReproducibleRandom random(m_Seed, OpenBiteStream);
    const bool         occurs = random.Uniform() < m_Level.openBiteProbability;
    const double       gap = random.Uniform(1.0, std::max(1.0, m_Level.openBiteGap));
    const double       spee = random.Uniform(0.0, 0.6);
    if (occurs)
    {
      m_Parameters.overbite = -gap;
      m_Parameters.speeDepth = spee;
      // Single teeth must not close what the arches leave open.
      for (unsigned int jaw = 0; jaw < 2; ++jaw)
      {
        for (unsigned int position = 0; position < 3; ++position)
        {
          for (const bool left : { false, true })
          {
            double & offset = this->Tooth(jaw, left, position).occlusalOffset;
            offset = std::min(offset, 0.0);
          }
        }
      }
      this->Note({ "open_bite", {}, gap }, true);
    }
  }

  void
  DeepBite()
  {
    ReproducibleRandom random(m_Seed, DeepBiteStream);
    const bool         occurs = random.Uniform() < m_Level.deepBiteProbability;
    const double       overlap = random.Uniform(4.5, std::max(4.5, m_Level.deepBiteOverlap));
    const double       room = random.Uniform(0.0, 1.5);
    const double       spee = random.Uniform(1.8, 3.0);
    if (occurs && m_Parameters.overbite > 0.0)
    {
      m_Parameters.overbite = overlap;
      m_Parameters.speeDepth = spee;
      // The lower edges must find place behind the upper crowns, which are thicker further up.
      m_Parameters.overjet = 4.4 + 0.5 * (overlap - 4.5) + room;
      for (const bool left : { false, true })
      {
        for (unsigned int position = 0; position < 2; ++position)
        {
          // Steep upper incisors, as deep bites have them.
          this->Tooth(0, left, position).torque -= 8.0 * Degree;
        }
      }
      this->Note({ "deep_bite", {}, overlap }, true);
    }
  }

  void
  CrossPosterior()
  {
    ReproducibleRandom random(m_Seed, PosteriorCrossbiteStream);
    const bool         occurs = random.Uniform() < m_Level.posteriorCrossbiteProbability;
    const bool         both = random.Uniform() < 0.3;
    const bool         left = random.Uniform() < 0.5;
    const unsigned int first = random.Uniform() < 0.5 ? 3 : 4;
    const double       upper = random.Uniform(2.4, 3.0);
    const double       lower = random.Uniform(1.8, 2.4);
    DentalPhantomTrait trait{ "crossbite_posterior", {}, upper + lower };
    for (const bool side : { false, true })
    {
      if (!occurs || (!both && side != left))
      {
        continue;
      }
      for (unsigned int position = first; position < 7; ++position)
      {
        // A narrow upper jaw; the lower teeth lean out.
        this->Tooth(0, side, position).buccalOffset -= upper;
        this->Tooth(1, side, position).buccalOffset += lower;
        trait.teeth.push_back(this->FDI(0, side, position));
      }
      // The teeth before them stand between.
      this->Tooth(0, side, first - 1).buccalOffset -= 0.4 * upper;
      this->Tooth(1, side, first - 1).buccalOffset += 0.4 * lower;
    }
    this->Note(trait);
  }

  void
  CrossAnterior()
  {
    ReproducibleRandom random(m_Seed, AnteriorCrossbiteStream);
    const bool         occurs = random.Uniform() < m_Level.anteriorCrossbiteProbability;
    const double       reverse = random.Uniform(2.0, 4.0);
    const double       overlap = random.Uniform(0.5, 2.0);
    // A deep bite hides the lower incisors, an open one has no overlap to reverse.
    if (occurs && m_Parameters.overbite > 0.0 && m_Parameters.overbite < 4.0)
    {
      m_Parameters.overjet = -reverse;
      m_Parameters.overbite = overlap;
      this->Note({ "crossbite_anterior", {}, reverse }, true);
    }
  }

  void
  Bond()
  {
    ReproducibleRandom random(m_Seed, BracketStream);
    const bool         occurs = random.Uniform() < m_Level.bracketProbability;
    const double       jaws = random.Uniform();
    DentalPhantomTrait trait{ "bracket", {}, 0.0 };
    for (unsigned int jaw = 0; jaw < 2; ++jaw)
    {
      const bool bonded = occurs && (jaws < 0.8 || (jaws < 0.9) == (jaw == 0));
      for (unsigned int i = 0; i < 14; ++i)
      {
        DentalPhantomTooth & tooth = m_Parameters.jaws[jaw].teeth[i];
        if (bonded && !tooth.missing && i % 7 < 6)
        {
          tooth.bracket = true;
          trait.teeth.push_back(DentalPhantomDentition::ToothFDI(jaw, i));
        }
      }
    }
    this->Note(trait);
  }

  void
  TrimGingiva()
  {
    if (m_Level.gingivaLeast == 1.0 && m_Level.gingivaMost == 1.0)
    {
      return;
    }
    ReproducibleRandom random(m_Seed, GingivaStream);
    double             least = 100.0;
    for (auto & jaw : m_Parameters.jaws)
    {
      const double factor = random.Uniform(std::min(m_Level.gingivaLeast, m_Level.gingivaMost), m_Level.gingivaMost);
      for (double * const flange : { &jaw.buccalFlange, &jaw.lingualFlange })
      {
        *flange = std::max(1.0, factor * *flange);
        least = std::min(least, *flange);
      }
    }
    this->Note({ "gingiva", {}, least }, true);
  }

  void
  Scan()
  {
    DentalPhantomScan & scan = m_Parameters.scan;
    scan.decimateTo = m_Level.decimateTo;
    scan.holeRadius = m_Level.holeRadius;
    scan.seed = ReproducibleRandom(m_Seed, ScanStream).NextBits();
    // Each jaw has its own; the numbers are those of both, drawn once.
    ReproducibleRandom flaps(m_Seed, FlapStream);
    ReproducibleRandom crumbs(m_Seed, CrumbStream);
    ReproducibleRandom specks(m_Seed, SpeckStream);
    ReproducibleRandom holes(m_Seed, HoleStream);
    scan.flaps = flaps.Uniform() < m_Level.flapProbability ? 1 + flaps.Integer(3) : 0;
    scan.crumbs = crumbs.Uniform() < m_Level.crumbProbability ? 1 + crumbs.Integer(3) : 0;
    // Uniform from none to twice the mean.
    scan.specks = specks.Integer(static_cast<std::uint32_t>(std::lround(2.0 * m_Level.meanSpecks)) + 1);
    scan.holes = holes.Integer(static_cast<std::uint32_t>(std::lround(2.0 * m_Level.meanHoles)) + 1);
    const std::pair<const char *, std::uint32_t> things[] = {
      { "flap", scan.flaps }, { "crumb", scan.crumbs }, { "speck", scan.specks }, { "hole", scan.holes }
    };
    for (const auto & thing : things)
    {
      if (thing.second > 0)
      {
        this->Note({ thing.first, {}, static_cast<double>(thing.second) }, true);
      }
    }
  }

  std::vector<DentalPhantomTrait>
  GetTraits() const
  {
    return m_Traits;
  }

private:
  DentalPhantomTooth &
  Tooth(unsigned int jaw, bool left, unsigned int position)
  {
    return m_Parameters.jaws[jaw].GetTooth(DentalPhantomJaw::GetIndex(left, position));
  }

  static unsigned int
  FDI(unsigned int jaw, bool left, unsigned int position)
  {
    return DentalPhantomDentition::ToothFDI(jaw, DentalPhantomJaw::GetIndex(left, position));
  }

  bool
  IsTaken(unsigned int jaw, bool left, unsigned int position)
  {
    const DentalPhantomTooth & tooth = this->Tooth(jaw, left, position);
    return tooth.missing || tooth.primary;
  }

  void
  Note(const DentalPhantomTrait & trait, bool whole = false)
  {
    if (whole || !trait.teeth.empty())
    {
      m_Traits.push_back(trait);
    }
  }

  std::uint64_t                   m_Seed;
  const DentalPhantomLevel &      m_Level;
  DentalPhantomParameters &       m_Parameters;
  std::vector<DentalPhantomTrait> m_Traits;
};
} // namespace

std::vector<DentalPhantomTrait>
DentalPhantomTraits::Apply(std::uint64_t seed, const DentalPhantomLevel & level, DentalPhantomParameters & parameters)
{
  Giver giver(seed, level, parameters);
  giver.ExtractAndClose();
  giver.LoseAndDrift();
  giver.KeepMilkMolars();
  giver.AddThirdMolars();
  giver.SinkMolar();
  giver.Wear();
  giver.Crowd();
  giver.OpenBite();
  giver.DeepBite();
  giver.CrossPosterior();
  giver.CrossAnterior();
  giver.Bond();
  giver.TrimGingiva();
  giver.Scan();
  return giver.GetTraits();
}
} // namespace itk
