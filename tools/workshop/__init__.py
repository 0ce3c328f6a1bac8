# SPDX-License-Identifier: BSL-1.0
"""What the workbook and the build read and write as text, a module a job."""
