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
#include "itkCaseLandmarkErrorFilter.h"
#include "itkCaseRegistrationTestCase.h"
#include "itkCaseResultFolderWriter.h"
#include "itkDentalCaseReader.h"
#include "itkDentalPhantomCaseWriter.h"
#include "itkMessageOfCall.h"
#include "itkTestFile.h"

#include "itkCommand.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

// Reader, registration and writer as one pipeline.
namespace
{
/** Counts the executions of a process object. */
class ExecutionCounter
{
public:
  explicit ExecutionCounter(itk::ProcessObject * process)
  {
    auto command = itk::FunctionCommand::New();
    command->SetCallback([this](const itk::EventObject &) { ++m_Count; });
    process->AddObserver(itk::StartEvent(), command);
  }
  unsigned int
  Get() const
  {
    return m_Count;
  }

private:
  unsigned int m_Count{ 0 };
};

std::string
WriteCase()
{
  auto source = itk::DentalPhantomCaseSource::New();
  source->SetSeed(15);
  source->SetNumberOfTriangles(12000);
  source->MakeRadiographOff();
  source->Update();
  auto writer = itk::DentalPhantomCaseWriter::New();
  writer->SetCaseSource(source);
  writer->SetDirectoryName(itk::TestFolder() + "/case");
  writer->Update();
  return itk::TestFolder() + "/case/case.json";
}
} // namespace

TEST(CasePipeline, OneUpdateOfTheWriterRunsAllAndAChangeRunsWhatLiesBelow)
{
  auto reader = itk::DentalCaseReader::New();
  reader->SetFileName(WriteCase());
  auto registration = itk::CaseRegistration::New();
  registration->SetInput(reader->GetOutput());
  auto writer = itk::CaseResultFolderWriter::New();
  auto errors = itk::CaseLandmarkErrorFilter::New();
  errors->SetInput(registration->GetOutput());
  writer->SetInput(errors->GetOutput());
  writer->SetFolderName(itk::TestFolder() + "/result");
  writer->WriteReportOff();
  const ExecutionCounter readings(reader);
  const ExecutionCounter registrations(registration);
  const ExecutionCounter measurements(errors);
  writer->Update();
  EXPECT_EQ(readings.Get(), 1u);
  EXPECT_EQ(registrations.Get(), 1u);
  EXPECT_TRUE(std::filesystem::exists(itk::TestFolder() + "/result/result.json"));
  EXPECT_EQ(registration->GetResult().GetStatus(), itk::RegistrationStatusEnum::Ok);
  EXPECT_EQ(measurements.Get(), 1u);
  // The marks are known below the registration alone.
  EXPECT_TRUE(registration->GetResult().markedLandmarks.IsNull());
  for (const auto & entry : registration->GetResult().jaws)
  {
    EXPECT_FALSE(entry.second.error);
    const auto & measured = errors->GetOutput()->Get().jaws.at(entry.first);
    ASSERT_TRUE(measured.error);
    EXPECT_GT(measured.error->count, 0u);
    EXPECT_EQ(measured.projection, entry.second.projection);
  }

  writer->Update();
  EXPECT_EQ(readings.Get(), 1u);
  EXPECT_EQ(registrations.Get(), 1u);
  EXPECT_EQ(measurements.Get(), 1u);

  registration->SetOption("maximumEvaluations=10");
  writer->Update();
  EXPECT_EQ(readings.Get(), 1u);
  EXPECT_EQ(registrations.Get(), 2u);

  reader->Modified();
  writer->Update();
  EXPECT_EQ(readings.Get(), 2u);
  EXPECT_EQ(registrations.Get(), 3u);
}

TEST(CasePipeline, SaysWhatToCallWhereAnInputIsMissing)
{
  const auto messageOf = [](itk::ProcessObject * process) -> std::string {
    return itk::MessageOfCall([&] { process->Update(); });
  };
  EXPECT_NE(messageOf(itk::DentalCaseReader::New()).find("SetFileName()"), std::string::npos);
  EXPECT_NE(messageOf(itk::CaseRegistration::New()).find("SetInput()"), std::string::npos);
  EXPECT_NE(messageOf(itk::CaseLandmarkErrorFilter::New()).find("SetInput()"), std::string::npos);
  EXPECT_NE(messageOf(itk::CaseResultFolderWriter::New()).find("SetInput()"), std::string::npos);
  auto registration = itk::CaseRegistration::New();
  registration->SetInput(itk::DentalCaseObject::New());
  EXPECT_NE(messageOf(registration).find("holds no case"), std::string::npos);
}
