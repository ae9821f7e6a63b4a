"""What the tests of many registrations share."""
import pytest

from program_runs import ProgramRuns


@pytest.fixture(scope="session")
def runs(program, shared_folder, tmp_path_factory):
    made = ProgramRuns(program, tmp_path_factory.mktemp("runs"), shared_folder)
    yield made
    made.close()
