"""The types that editors see are those of the package."""
import inspect
import pathlib
import unittest

import make_stub
from support import ROOT, Case

import velum


class Stub(Case):
    def test_it_is_this_one(self):
        path = ROOT / "python/velum/__init__.pyi"
        now = make_stub.stub()
        if path.read_text() == now:
            return
        beside = pathlib.Path(f"{path}.new")
        beside.write_text(now)
        self.fail(f"the package has changed; look at the difference, then accept it with\n  mv {beside} {path}")

    def test_it_is_python(self):
        compile((ROOT / "python/velum/__init__.pyi").read_text(), "__init__.pyi", "exec")

    def test_everything_says_what_it_is(self):
        for name in velum.__all__:
            self.assertTrue(getattr(velum, name).__doc__, name)
            for member, value in vars(getattr(velum, name)).items():
                if not member.startswith("_") and (inspect.isfunction(value) or isinstance(value, property)):
                    self.assertTrue(value.__doc__ or value.fget.__doc__, f"{name}.{member}")


if __name__ == "__main__":
    unittest.main()
