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
#ifndef itkDentalCaseData_h
#define itkDentalCaseData_h

#include "itkCaseInputFile.h"
#include "itkDentalCase.h"
#include "itkDentalRadiographData.h"
#include "itkDentalViewData.h"

#include "itkDentalContour.h"
#include "itkDentalLandmarkSet.h"
#include "itkMesh.h"

#include <cstdint>
#include <vector>

namespace itk
{
/** \struct DentalCaseData
 * \brief A case in memory: scans in mm, tracing and landmarks to register with, radiograph, nominal geometry with the
 * origin of each value.
 *
 * It has none of the 2-D landmarks by which errors are measured: what registers can't see them.
 *
 * \ingroup CaseRegistration
 */
struct DentalCaseData : public DentalRadiographData
{
  using MeshType = Mesh<float, 3>;
  using JawEnum = ToothCode::JawEnum;
  /** What was read of one jaw. */
  struct JawType
  {
    /** Mesh-file frame, mm; null without a scan. */
    MeshType::Pointer mesh;
    /** FDI number by point of the mesh, 0 gingiva; empty where no labels were read. */
    std::vector<std::uint8_t> labels;
    /** Continuous pixel indices; null without a tracing. */
    DentalContour::Pointer contour;
  };

  DentalCase description; /**< What the case file said, or the program that made the case. */
  JawType    upper;       /**< Upper jaw; without a mesh where the case has none. */
  JawType    lower;       /**< Lower jaw; without a mesh where the case has none. */
  /** In the mesh files' unit and frame; null where none were given. */
  DentalLandmarkSet<3>::Pointer landmarks3D;
  /** Pixels of whatever picture; null where none were given. */
  DentalContour::Pointer stockOutlines;
  /** Radiographs beside the lateral one. */
  std::vector<DentalViewData> views;
  /** The files that all this was read from, the case file first. */
  std::vector<CaseInputFile> inputs;
  std::vector<std::string>   warnings;
  double                     readSeconds{ 0.0 };

  /** What was read of a jaw; the upper one's for any other value than Lower. */
  const JawType &
  GetJaw(JawEnum jaw) const
  {
    return jaw == JawEnum::Lower ? lower : upper;
  }
  JawType &
  GetJaw(JawEnum jaw)
  {
    return jaw == JawEnum::Lower ? lower : upper;
  }
};
} // namespace itk

#endif
