#!/usr/bin/python3
"""Records 200 steps of Adam by PyTorch on a 3-4-6-3-1 network, for tests/unit/surrogate_torch_test.cpp.

    apt-get install python3-torch
    tests/reference/adam_torch.py > tests/reference/adam_torch.json

PyTorch adds epsilon after the bias correction (Algorithm 1 of Kingma and Ba), Keras before it (the last lines before
their section 2.1). Setting PyTorch's epsilon anew before each step, to 1e-7 / sqrt(1 - beta2^t), makes both the same.
Everything is in double precision; batches are taken in the order of the rows.
"""
import json
import math

import torch

torch.manual_seed(3)
torch.set_default_dtype(torch.float64)
torch.set_num_threads(1)
layers, rows, batch, steps, keep = [3, 4, 6, 3, 1], 20, 4, 200, (1, 10, 100, 200)
beta2, epsilon = 0.999, 1e-7

modules = []
for below, above in zip(layers, layers[1:]):
    modules += [torch.nn.Linear(below, above), torch.nn.ReLU()]
    torch.nn.init.kaiming_normal_(modules[-2].weight, nonlinearity="relu")
    torch.nn.init.constant_(modules[-2].bias, 0.1)
network = torch.nn.Sequential(*modules)
inputs = torch.rand(rows, layers[0]) * 0.98 + 0.01
targets = (inputs[:, 0] * (0.5 + inputs[:, 1]) / (1.0 + inputs[:, 2])).reshape(-1, 1)


def parameters():
    return [value for parameter in network.parameters() for value in parameter.detach().flatten().tolist()]


record = {
    "torch": torch.__version__,
    "layers": layers,
    "batch": batch,
    "inputs": inputs.tolist(),
    "targets": targets.flatten().tolist(),
    "initial": parameters(),
    "after": {},
}
adam = torch.optim.Adam(network.parameters(), lr=1e-3, betas=(0.9, beta2))
for step in range(1, steps + 1):
    first = (step - 1) * batch % rows
    adam.param_groups[0]["eps"] = epsilon / math.sqrt(1.0 - beta2**step)
    adam.zero_grad()
    torch.nn.functional.mse_loss(network(inputs[first : first + batch]), targets[first : first + batch]).backward()
    adam.step()
    if step in keep:
        record["after"][str(step)] = parameters()
print(json.dumps(record, indent=1))
