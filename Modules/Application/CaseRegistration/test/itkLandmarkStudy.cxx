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
#include "itkCaseLandmarksTestCase.h"

#include <iostream>

// Makes the tables of Documentation/Landmarks.md: LandmarkStudy LEVEL landmarks_3d|shape FIRST_SEED COUNT
// [landmarks|outlines|both].
int
main(int argc, char * argv[])
{
  using JawEnum = itk::ToothCode::JawEnum;
  const bool                                              shape = argc >= 5 && std::string(argv[2]) == "shape";
  const std::string                                       given = argc >= 6 ? argv[5] : "landmarks";
  const std::map<std::string, LandmarkCase::EvidenceEnum> kinds{ { "landmarks", LandmarkCase::EvidenceEnum::Landmarks },
                                                                 { "outlines", LandmarkCase::EvidenceEnum::Outlines },
                                                                 { "both", LandmarkCase::EvidenceEnum::Both } };
  if (argc < 5 || (!shape && std::string(argv[2]) != "landmarks_3d") || kinds.count(given) == 0)
  {
    std::cerr << "usage: LandmarkStudy LEVEL landmarks_3d|shape FIRST_SEED COUNT [landmarks|outlines|both]"
              << std::endl;
    return 2;
  }
  const std::uint64_t first = std::stoull(argv[3]);
  const std::uint64_t count = std::stoull(argv[4]);
  double              sum = 0.0;
  double              worst = 0.0;
  unsigned int        registered = 0, near = 0, nearAndOk = 0, farAndOk = 0, covered = 0, middles = 0;
  std::cout << "case jaw error_px status sigma_px largest_sigma_px" << std::endl;
  for (std::uint64_t seed = first; seed < first + count; ++seed)
  {
    LandmarkCase phantom(seed, argv[1], argc == 7 ? std::stod(argv[6]) : 1.0, kinds.at(given));
    if (shape)
    {
      phantom.data->landmarks3D = nullptr;
    }
    if (std::getenv("LABELS")) { for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower }) { auto & l = phantom.data->GetJaw(jaw).labels; l.clear(); for (auto it = phantom.data->GetJaw(jaw).mesh->GetPointData()->Begin(); it != phantom.data->GetJaw(jaw).mesh->GetPointData()->End(); ++it) l.push_back(static_cast<std::uint8_t>(it.Value())); } }
    const auto result = phantom.Run();
    for (const auto & entry : result.jaws)
    {
      const itk::JawResult & jaw = entry.second;
      const char *           name = entry.first == JawEnum::Upper ? "upper" : "lower";
      if (!jaw.registered)
      {
        std::cout << seed << ' ' << name << " - " << itk::ToString(jaw.status);
        for (const std::string & reason : jaw.reasons)
        {
          std::cout << " | " << reason;
        }
        std::cout << std::endl;
        continue;
      }
      const double error = MiddleError(phantom, result, entry.first);
      const bool   ok = jaw.status == itk::CaseStatusEnum::Ok;
      ++registered;
      sum += error;
      worst = std::max(worst, error);
      near += error <= 4.0 ? 1 : 0;
      nearAndOk += error <= 4.0 && ok ? 1 : 0;
      farAndOk += error > 8.0 && ok ? 1 : 0;
      const auto errors = MiddleErrors(phantom, result, entry.first);
      for (const auto & middle : jaw.middles)
      {
        const auto found = errors.find(middle.name);
        covered += found != errors.end() && found->second < 2.448 * middle.sigma ? 1 : 0;
        middles += found != errors.end() ? 1 : 0;
      }
      for (const auto & o : jaw.usedOutlines) { std::cout << o.name << " (" << o.shift[0] << " " << o.shift[1] << ") d " << o.distance << " w " << o.weight << " m " << o.matchedShare << "; "; }

#pragma GCC diagnostic ignored "-Wmisleading-indentation"
 for (const auto & d : jaw.details) if (d.first == "pitch_rad" || d.first=="scale_factor" || d.first=="roll_rad" || d.first=="yaw_rad") std::cout << d.first << ' ' << d.second << ' '; { const auto & P = jaw.projection; for (const char * nm : {"1_tip", "6_MB"}) { double e[2] = {0,0}; for (const char * sd : {"R", "L"}) { std::string full = std::string(entry.first == JawEnum::Upper ? "U" : "L") + sd + nm; auto * s3 = phantom.source->GetLandmarks3D(entry.first == JawEnum::Upper ? 0 : 1)->Find(full); auto * m2 = phantom.marked->Find(full); if (!s3 || !m2) continue; double h[3]; for (int r = 0; r < 3; ++r) { h[r] = P[4*r+3]; for (int c = 0; c < 3; ++c) h[r] += P[4*r+c]*s3->point[c]; } e[0] += 0.5*(h[0]/h[2]-m2->point[0]); e[1] += 0.5*(h[1]/h[2]-m2->point[1]); } std::cout << nm << " err (" << e[0] << ", " << e[1] << ") "; } }
 std::cout << std::endl;
      std::cout << seed << ' ' << name << ' ' << error << ' ' << itk::ToString(jaw.status) << ' '
                << Detail(jaw, "middle_sigma_px") << ' ' << Detail(jaw, "largest_middle_sigma_px");
      for (const std::string & reason : jaw.reasons)
      {
        std::cout << " | " << reason;
      }
      std::cout << std::endl;
    }
  }
  std::cout << "jaws " << registered << ", mean " << sum / registered << " px, worst " << worst << " px; within 4 px "
            << near << ", of these ok " << nearAndOk << "; beyond 8 px and ok " << farAndOk << "; covered " << covered
            << " of " << middles << std::endl;
  return 0;
}
