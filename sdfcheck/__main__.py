"""``python -m sdfcheck``."""

from __future__ import annotations

import sys

from sdfcheck.cli.main import main

sys.exit(main())
