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
