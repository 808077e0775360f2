"""python -m mien …: the command, with the same words."""
import os
import sys

from ._command import needed
from ._errors import Error


def main() -> int:
    try:
        command = needed("python -m mien")
    except Error as error:
        print(error, file=sys.stderr)
        return 1
    os.execv(command, ["mien", *sys.argv[1:]])


if __name__ == "__main__":
    sys.exit(main())
