(record) @indent.begin
