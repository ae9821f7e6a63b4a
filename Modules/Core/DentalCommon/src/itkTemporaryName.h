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
#ifndef itkTemporaryName_h
#define itkTemporaryName_h

#include <string>

namespace itk
{
/** A name in a folder that no other temporary has. It is short whatever it stands for: a name of 250 characters can be
 * written, too. */
std::string
MakeTemporaryName(const std::string & folder);

/** Locks what a temporary is, a file or a folder, for as long as the descriptor is open.
 * \return whether it is still there: a sweep may have found it before it was locked */
bool
LockTemporary(int descriptor);

/** Removes the temporaries in a folder that no process has locked: those that killed runs have left. */
void
SweepTemporaries(const std::string & folder);

/** The same, once a process and folder: a folder may have thousands of files. */
void
SweepTemporariesOnce(const std::string & folder);
} // namespace itk

#endif
