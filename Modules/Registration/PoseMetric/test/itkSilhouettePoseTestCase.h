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
#ifndef itkSilhouettePoseTestCase_h
#define itkSilhouettePoseTestCase_h

#include "itkPosePhantom.h"
#include "itkSilhouettePoseMetricv4.h"

#include <memory>

/** The terms of a phantom's jaws, at the truth. */
struct SilhouettePoseTestCase : PosePhantom
{
  using MetricType = itk::SilhouettePoseMetricv4;
  using TransformType = itk::CephalometricPoseTransform;
  using JawEnum = MetricType::JawEnum;

  using PosePhantom::PosePhantom;

  /** The true geometry with the true pose: the meshes' frame is the dental one. */
  TransformType::Pointer
  MakeTransform(unsigned int jaw) const
  {
    auto transform = TransformType::New();
    transform->SetGeometry(trueGeometry[jaw]);
    transform->SetParametersFromRotation(
      trueGeometry[jaw]->GetPoseRotation(), trueGeometry[jaw]->GetPoseTranslation(), 0.0);
    return transform;
  }

  MetricType::Pointer
  MakeMetric(unsigned int jaw) const
  {
    auto metric = MetricType::New();
    metric->SetTransform(this->MakeTransform(jaw));
    metric->SetMovingSurface(std::make_shared<const itk::TriangleSurface>(surfaces[jaw]));
    metric->SetFixedContour(contours[jaw]);
    metric->SetJaw(jaw == 0 ? JawEnum::Upper : JawEnum::Lower);
    return metric;
  }
};

#endif
