# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""The reports of a run and of a sweep. They put together what the rooms make: `text` first, then `drawings`, which know the text."""
