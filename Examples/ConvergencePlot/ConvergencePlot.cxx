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
// Every iteration of two registrations, the paper's and preset robust, logged by the same command: tables for plot.py.
#include "itkDentalPhantomCaseSource.h"
#include "itkMeshSilhouetteContourSource.h"
#include "itkPoseRegistrationMethod.h"
#include "itkRegistrationIterationCommand.h"
#include "itkSilhouetteToContourRegistrationMethod.h"
#include "itkUMidlineDentalAxisFilter.h"

#include <cstdlib>
#include <fstream>
#include <iostream>

namespace
{
/** Runs any registration method of the toolkit and writes a row for each of its iterations. */
void
Log(itk::ProcessObject * registration, const std::string & name, const std::string & fileName)
{
  auto log = itk::RegistrationIterationCommand::New();
  log->Observe(registration);
  registration->Update();
  std::ofstream table(fileName);
  log->WriteTable(table);
  std::size_t iterations = 0;
  for (const auto & record : log->GetRecords())
  {
    iterations += record.kind == itk::RegistrationIterationCommand::KindEnum::Iteration ? 1 : 0;
  }
  std::cout << name << " iterations: " << iterations << '\n'
            << name << " stopped by: " << log->GetRecords().back().stopReason << std::endl;
}
} // namespace

int
main(int argc, char * argv[])
{
  if (argc != 3)
  {
    std::cerr << "Usage: " << argv[0] << " paper.csv robust.csv" << std::endl;
    return EXIT_FAILURE;
  }
  using MeshType = itk::Mesh<float, 3>;
  try
  {
    auto phantom = itk::DentalPhantomCaseSource::New();
    phantom->SetSeed(3);
    phantom->MakeRadiographOff();
    phantom->Update();
    auto axis = itk::UMidlineDentalAxisFilter<MeshType>::New();
    axis->SetUpperMesh(phantom->GetMesh(0));
    axis->SetLowerMesh(phantom->GetMesh(1));
    axis->RefineMidlineOn();

    auto silhouette = itk::MeshSilhouetteContourSource<MeshType>::New();
    silhouette->SetInput(axis->GetUpperOutput());
    silhouette->SetGeometry(phantom->GetNominalGeometry());
    silhouette->SetNumberOfPoints(441);
    auto paper = itk::SilhouetteToContourRegistrationMethod::New();
    paper->SetFixedContour(phantom->GetTracing(0));
    paper->SetMovingContour(silhouette->GetOutput());
    Log(paper, "paper", argv[1]);

    auto robust = itk::PoseRegistrationMethod<MeshType>::New();
    robust->SetUpperMesh(phantom->GetMesh(0));
    robust->SetLowerMesh(phantom->GetMesh(1));
    robust->SetUpperContour(phantom->GetTracing(0));
    robust->SetLowerContour(phantom->GetTracing(1));
    robust->SetGeometry(phantom->GetNominalGeometry());
    robust->SetUpperFrame(axis->GetUpperTransformOutput());
    robust->SetLowerFrame(axis->GetLowerTransformOutput());
    robust->SetJointFrame(axis->GetJointTransformOutput());
    Log(robust, "robust", argv[2]);
  }
  catch (const itk::ExceptionObject & error)
  {
    std::cerr << error.GetDescription() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
