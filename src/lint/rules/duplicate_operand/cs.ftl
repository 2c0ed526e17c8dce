W333 = sjednocení { $id } obsahuje tentýž objekt dvakrát na jednom místě: { $one } { $one-id } a jeho neposunutou kopii { $two-id }
    .label = tato kopie zůstává na místě
    .one = { $one }
    .help = posuňte kopii, například pomocí `{ $two-id } -1 x y z`, nebo ji ze sjednocení vynechte
W333-same = { $type } { $id } má za oba operandy { $one-id }: je to totéž jako samotný { $one-id }
    .label = tentýž objekt podruhé
    .help = napište sem jiný objekt, nebo místo { $id } použijte { $one-id }
