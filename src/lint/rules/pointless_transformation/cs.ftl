W327 = { $type } s těmito čísly nic nemění
    .label = vše zůstává tam, kde je
    .help = napište čísla, která jste měli na mysli, nebo záznam odstraňte
    .fix = odstranit záznam
