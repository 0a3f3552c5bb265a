"""The browser that all tests of this folder share."""

from tests.viewer.test_page import browser, show  # noqa: F401
