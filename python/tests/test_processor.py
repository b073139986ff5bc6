import pytest

from equilibria import processor


def test_missing_instructions_are_an_import_error(monkeypatch):
    monkeypatch.setattr(processor, "present", lambda: frozenset({"avx"}))
    processor.require(["avx"])
    with pytest.raises(ImportError, match="avx512f, which this one has not"):
        processor.require(["avx", "avx512f"])
    monkeypatch.setattr(processor, "present", lambda: None)
    processor.require(["avx512f"])
