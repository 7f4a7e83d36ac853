"""The stub says what is there, no more and no less, and everything has a docstring."""
import ast
import importlib.resources
import inspect

import handlebody
from handlebody import _core

STUB = ast.parse((importlib.resources.files("handlebody") / "__init__.pyi").read_text())


def public(names):
    return {name for name in names if not name.startswith("_")}


def classes():
    return {node.name: node for node in STUB.body if isinstance(node, ast.ClassDef) and not node.name.startswith("_")}


def functions(body):
    return {node.name: node for node in body if isinstance(node, ast.FunctionDef)}


def test_the_stub_has_every_public_name():
    assert public(classes()) | public(functions(STUB.body)) == set(handlebody.__all__)
    assert public(vars(handlebody)) == set(handlebody.__all__)
    assert (importlib.resources.files("handlebody") / "py.typed").is_file()


def test_the_stub_has_every_member():
    for name, node in classes().items():
        if issubclass(getattr(handlebody, name), BaseException):
            continue
        assert public(functions(node.body)) == public(vars(getattr(handlebody, name))), name


def test_the_contour_takes_the_options_that_the_stub_lists():
    for name in ("__init__", "change"):
        arguments = functions(classes()["Contour"].body)[name].args
        assert [a.arg for a in arguments.kwonlyargs] == _core.option_names


def test_docstrings_begin_with_the_arguments_of_the_stub():
    nodes = {**functions(STUB.body)}
    for name, node in classes().items():
        for member, f in functions(node.body).items():
            if not any(getattr(d, "id", "") == "property" for d in f.decorator_list) and member != "__init__":
                nodes[f"{name}.{member}"] = f
    for name, node in nodes.items():
        found = handlebody
        for part in name.split("."):
            found = getattr(found, part)
        first = inspect.getdoc(found).splitlines()[0]
        assert first.startswith(name.split(".")[-1] + "("), name
        for argument in [*node.args.args, *node.args.kwonlyargs]:
            assert argument.arg == "self" or name == "Contour.change" or argument.arg in first, (name, argument.arg)


def test_everything_has_a_docstring():
    for name in handlebody.__all__:
        found = getattr(handlebody, name)
        assert len(found.__doc__) > 20, name
        assert found.__module__ == "handlebody"
        for member, value in vars(found).items() if inspect.isclass(found) else ():
            if not member.startswith("_"):
                assert value.__doc__, f"{name}.{member}"
