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
#include "itkDentalFrameCohort.h"
#include "itkJawExchangeEvidence.h"

#include <cstdlib>
#include <iostream>
#include <string>

// Makes the tables of Documentation/UMDA.md: DentalFrameStudy occlusion|axes|exchange LEVEL FIRST_SEED COUNT. One line
// a pair and arrangement (occlusion) or a jaw (axes), then the summary.
namespace
{
using namespace DentalFrameTest;

void
Put(std::ostream & file, const itk::TriangleSurface & surface)
{
  const std::array<std::uint64_t, 2> sizes{ { surface.points.size(), surface.triangles.size() } };
  file.write(reinterpret_cast<const char *>(sizes.data()), sizeof(sizes));
  file.write(reinterpret_cast<const char *>(surface.points.data()),
             static_cast<std::streamsize>(sizes[0] * sizeof(surface.points[0])));
  file.write(reinterpret_cast<const char *>(surface.triangles.data()),
             static_cast<std::streamsize>(sizes[1] * sizeof(surface.triangles[0])));
}

void
Get(std::istream & file, itk::TriangleSurface & surface)
{
  std::array<std::uint64_t, 2> sizes{ { 0, 0 } };
  file.read(reinterpret_cast<char *>(sizes.data()), sizeof(sizes));
  surface.points.resize(sizes[0]);
  surface.triangles.resize(sizes[1]);
  file.read(reinterpret_cast<char *>(surface.points.data()),
            static_cast<std::streamsize>(sizes[0] * sizeof(surface.points[0])));
  file.read(reinterpret_cast<char *>(surface.triangles.data()),
            static_cast<std::streamsize>(sizes[1] * sizeof(surface.triangles[0])));
}

/** Scans take a hundred times longer to make than frames to find: a folder keeps them from one run to the next. */
ScannedPair
LoadOrMake(std::uint64_t seed, const std::string & level, const std::string & folder)
{
  ScannedPair       pair;
  const std::string name = folder + "/" + level + "-" + std::to_string(seed) + ".bin";
  if (!folder.empty())
  {
    std::ifstream file(name, std::ios::binary);
    if (file)
    {
      Get(file, pair.jaws[0]);
      Get(file, pair.jaws[1]);
      std::getline(file, pair.traits);
      return pair;
    }
  }
  pair = MakeScannedPair(seed, level);
  if (!folder.empty())
  {
    std::ofstream file(name, std::ios::binary);
    Put(file, pair.jaws[0]);
    Put(file, pair.jaws[1]);
    file << pair.traits;
  }
  return pair;
}

void
StudyOcclusion(const std::string & level, std::uint64_t first, std::uint64_t count, const std::string & folder)
{
  std::vector<std::vector<std::string>>  lines(count);
  std::vector<std::vector<unsigned int>> wrong(count);
  itk::ParallelFor(count, 0, [&](std::size_t k) {
    const std::uint64_t seed = first + k;
    const ScannedPair   pair = LoadOrMake(seed, level, folder);
    for (const Arrangement arrangement : Arrangements)
    {
      const ArrangedPair      arranged = Arrange(pair, arrangement, seed);
      itk::DentalFrameOptions options;
      options.refineMidline = true;
      const auto result = itk::EstimateDentalFrame(&arranged.jaws[0], &arranged.jaws[1], options);
      bool       bad = result.jawsShareFrame != arranged.share;
      double     worst = 0.0;
      for (unsigned int jaw = 0; jaw < 2; ++jaw)
      {
        const auto & frame = jaw == 0 ? result.upper : result.lower;
        const double error = AxisErrors(frame, arranged.motions[jaw])[2];
        worst = std::max(worst, error);
      }
      bad = bad || worst > 30.0;
      wrong[k].push_back(bad ? 1 : 0);
      std::ostringstream line;
      line << NameOf(arrangement) << ' ' << seed << (bad ? " WRONG" : " right") << " share " << result.jawsShareFrame
           << " z " << worst << " crown " << result.crownDistance << " sep " << result.verticalSeparation << " gap "
           << result.crownPlaneGap << " centres " << result.archCentreDistance << " vertical "
           << result.verticalDisagreement << " anterior " << result.anteriorDisagreement << " winding "
           << result.upper.windingAgreement << ' ' << result.lower.windingAgreement << " arch " << result.archDistance
           << " inside " << result.interpenetration << " finding " << static_cast<int>(result.occlusionFinding);
      lines[k].push_back(line.str());
    }
  });
  for (std::uint64_t k = 0; k < count; ++k)
  {
    for (const std::string & line : lines[k])
    {
      std::cout << line << '\n';
    }
  }
  for (std::size_t a = 0; a < Arrangements.size(); ++a)
  {
    unsigned int sum = 0;
    for (const auto & w : wrong)
    {
      sum += w[a];
    }
    std::cout << "# " << NameOf(Arrangements[a]) << ": " << sum << " wrong of " << count << std::endl;
  }
}

void
StudyAxes(const std::string & level, std::uint64_t first, std::uint64_t count, const std::string & folder)
{
  std::vector<std::string> lines(count);
  itk::ParallelFor(count, 0, [&](std::size_t k) {
    const ScannedPair       pair = LoadOrMake(first + k, level, folder);
    itk::DentalFrameOptions options;
    options.refineMidline = true;
    options.jawsShareFrame = itk::DentalFrameEnums::JawsShareFrame::Off;
    const auto         result = itk::EstimateDentalFrame(&pair.jaws[0], &pair.jaws[1], options);
    std::ostringstream line;
    for (unsigned int jaw = 0; jaw < 2; ++jaw)
    {
      const auto &  frame = jaw == 0 ? result.upper : result.lower;
      const Vector3 errors = AxisErrors(frame, Motion());
      const double  degree = 180.0 / 3.14159265358979;
      line << (jaw == 0 ? "upper " : "lower ") << first + k << " x " << errors[0] << " yaw "
           << std::atan2(frame.axes[0][1], frame.axes[0][0]) * degree << " pitch "
           << std::atan2(frame.axes[0][2], frame.axes[0][0]) * degree << " confidence " << frame.confidence << " width "
           << frame.archWidth << " molars " << frame.molarWidth << " incisors "
           << itk::JawExchangeEvidence::MeasureIncisorContrast(
                pair.jaws[jaw], frame, jaw == 0 ? itk::ToothCode::JawEnum::Upper : itk::ToothCode::JawEnum::Lower)
                .value_or(std::nan(""))
           << ' ' << pair.traits << '\n';
    }
    lines[k] = line.str();
  });
  for (const std::string & line : lines)
  {
    std::cout << line;
  }
}

/** Whether scans are exchanged: what each measure says of the pair as named and with the scans exchanged, in one frame
 * and apart; then how often the alarm was raised with and without the incisors. */
void
StudyExchange(const std::string & level, std::uint64_t first, std::uint64_t count, const std::string & folder)
{
  using JawsShareFrame = itk::DentalFrameEnums::JawsShareFrame;
  std::vector<std::string> lines(count);
  // Alarms by: apart or in one frame, named or exchanged, without or with the incisors.
  std::vector<std::array<unsigned int, 8>> alarms(count);
  itk::ParallelFor(count, 0, [&](std::size_t k) {
    const ScannedPair  pair = LoadOrMake(first + k, level, folder);
    std::ostringstream text;
    for (unsigned int variant = 0; variant < 4; ++variant)
    {
      const bool              together = variant >= 2;
      const unsigned int      upper = variant % 2;
      itk::DentalFrameOptions options;
      options.refineMidline = true;
      options.jawsShareFrame = together ? JawsShareFrame::On : JawsShareFrame::Off;
      const auto result = itk::EstimateDentalFrame(&pair.jaws[upper], &pair.jaws[1 - upper], options);
      const itk::JawExchangeEvidence evidence(result, &pair.jaws[upper], &pair.jaws[1 - upper]);
      const auto &                   width = evidence.GetMolarWidthDifference();
      const auto &                   overjet = evidence.GetOverjet();
      const auto &                   incisors = evidence.GetIncisorContrastDifference();
      const double                   without = itk::JawExchangeEvidence(width, overjet).GetProbability();
      alarms[k][2 * variant] = without > 0.5 ? 1 : 0;
      alarms[k][2 * variant + 1] = evidence.GetProbability() > 0.5 ? 1 : 0;
      text << first + k << (together ? " together" : " apart") << (upper == 0 ? " named" : " exchanged") << " width "
           << width.value_or(std::nan("")) << " overjet " << overjet.value_or(std::nan("")) << " incisors "
           << incisors.value_or(std::nan("")) << " ratio of incisors "
           << itk::JawExchangeEvidence(std::nullopt, std::nullopt, incisors).GetLogLikelihoodRatio() << " without "
           << without << " with " << evidence.GetProbability() << ' ' << pair.traits << '\n';
    }
    lines[k] = text.str();
  });
  std::array<unsigned int, 8> sums{};
  for (std::uint64_t k = 0; k < count; ++k)
  {
    std::cout << lines[k];
    for (std::size_t i = 0; i < sums.size(); ++i)
    {
      sums[i] += alarms[k][i];
    }
  }
  for (unsigned int variant = 0; variant < 4; ++variant)
  {
    std::cout << "# alarms of " << count << (variant < 2 ? " pairs apart, " : " pairs in one frame, ")
              << (variant % 2 == 0 ? "as named" : "exchanged") << ": without incisors " << sums[2 * variant]
              << ", with them " << sums[2 * variant + 1] << std::endl;
  }
}
} // namespace

int
main(int argc, char * argv[])
{
  if (argc != 5 && argc != 6)
  {
    std::cerr << "usage: DentalFrameStudy occlusion|axes|exchange LEVEL FIRST_SEED COUNT [FOLDER]" << std::endl;
    return 2;
  }
  const std::string   what = argv[1];
  const std::uint64_t first = std::stoull(argv[3]);
  const std::uint64_t count = std::stoull(argv[4]);
  if (what == "occlusion")
  {
    StudyOcclusion(argv[2], first, count, argc == 6 ? argv[5] : "");
  }
  else if (what == "exchange")
  {
    StudyExchange(argv[2], first, count, argc == 6 ? argv[5] : "");
  }
  else if (what == "axes")
  {
    StudyAxes(argv[2], first, count, argc == 6 ? argv[5] : "");
  }
  return 0;
}
