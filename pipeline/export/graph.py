"""A small writer of ONNX graphs: nodes are added one by one, every array is a constant of the graph's own type."""

from typing import Any

import numpy as np
import onnx
from numpy.typing import DTypeLike
from onnx import TensorProto, helper, numpy_helper

OPSET, IR = 17, 8  # old enough for any runtime of the last years


class Graph:
    """Nodes and constants of one graph whose numbers are float32 or float64; values go by their names."""

    def __init__(self, kind: DTypeLike) -> None:
        self.kind = np.dtype(kind)
        self.type = helper.np_dtype_to_tensor_dtype(self.kind)
        self.nodes: list[Any] = []
        self.constants: list[Any] = []

    def add(self, operation: str, *inputs: Any, **attributes: Any) -> str:
        """One node's first output; an input that is no name becomes a constant."""
        names = [operand if isinstance(operand, str) else self.constant(operand) for operand in inputs]
        output = f"v{len(self.nodes)}"
        self.nodes.append(helper.make_node(operation, names, [output], **attributes))
        return output

    def constant(self, values: Any, kind: DTypeLike | None = None) -> str:
        """A constant array, of the graph's type unless another is given."""
        name = f"c{len(self.constants)}"
        self.constants.append(numpy_helper.from_array(np.asarray(values, kind or self.kind), name))
        return name

    def whole(self, values: Any) -> str:
        """A constant array of whole numbers: axes, positions, permutations."""
        return self.constant(values, np.int64)

    def columns(self, table: str, positions: Any) -> str:
        """Columns of a table, shape (points, positions)."""
        return self.add("Gather", table, self.whole(positions), axis=1)

    def beside(self, *tables: str) -> str:
        """Tables side by side."""
        return tables[0] if len(tables) == 1 else self.add("Concat", *tables, axis=1)

    def clipped(self, values: str, low: float, high: float) -> str:
        """Values brought between two bounds."""
        return self.add("Clip", values, low, high)

    def sum(self, values: str) -> str:
        """Sum of each row, shape (points, 1)."""
        return self.add("ReduceSum", values, self.whole([1]), keepdims=1)

    def number(self, truth: str) -> str:
        """1 where something is true, 0 where not."""
        return self.add("Cast", truth, to=self.type)

    def all(self, truths: list[str]) -> str:
        """Where all of these are true."""
        result = truths[0]
        for truth in truths[1:]:
            result = self.add("And", result, truth)
        return result

    def model(self, name: str, columns: int, value: str, inside: str, metadata: dict[str, str]) -> onnx.ModelProto:
        """The checked model: one table of queries in, `value` and `inside` out, one of each a point."""
        flat = self.whole([-1])
        self.nodes.append(helper.make_node("Reshape", [value, flat], ["value"]))
        self.nodes.append(helper.make_node("Reshape", [inside, flat], ["inside"]))
        used = {input_name for node in self.nodes for input_name in node.input}
        graph = helper.make_graph(
            self.nodes,
            name,
            [helper.make_tensor_value_info("queries", self.type, ["points", columns])],
            [
                helper.make_tensor_value_info("value", self.type, ["points"]),
                helper.make_tensor_value_info("inside", TensorProto.BOOL, ["points"]),
            ],
            [array for array in self.constants if array.name in used],
        )
        onnx_model = helper.make_model(graph, opset_imports=[helper.make_opsetid("", OPSET)], ir_version=IR)
        helper.set_model_props(onnx_model, metadata)
        onnx.checker.check_model(onnx_model, full_check=True)
        return onnx_model
